//! Pictures: a picture tells what text cannot, so defects must be seen in it where they are.

use std::collections::BTreeSet;

use serde_json::{Value, json};

use crate::kit::{Kit, program};

/// A picture as a client gets it.
struct Seen {
    png: Vec<u8>,
    caption: String,
    width: usize,
    height: usize,
    pixels: Vec<[u8; 3]>,
}

/// Calls `render`, which must answer with a text and a picture and nothing structured.
fn render(kit: &mut Kit, arguments: Value) -> Seen {
    let answer = kit.session.call("render", arguments.clone()).unwrap();
    assert!(!answer.is_error, "{arguments}: {}", answer.content);
    assert_eq!(
        answer.content,
        Value::Null,
        "clients would show nothing else"
    );
    let blocks = answer.blocks.as_array().unwrap();
    assert_eq!(blocks.len(), 2, "{arguments}");
    assert_eq!(
        (&blocks[0]["type"], &blocks[1]["type"]),
        (&json!("text"), &json!("image"))
    );
    assert_eq!(blocks[1]["mimeType"], "image/png");
    let png = base64(blocks[1]["data"].as_str().unwrap());
    let mut reader = png::Decoder::new(std::io::Cursor::new(&png))
        .read_info()
        .unwrap();
    let mut bytes = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut bytes).unwrap();
    Seen {
        caption: blocks[0]["text"].as_str().unwrap().to_owned(),
        width: info.width as usize,
        height: info.height as usize,
        pixels: bytes.as_chunks::<3>().0.to_vec(),
        png,
    }
}

/// RFC 4648, written out.
fn base64(text: &str) -> Vec<u8> {
    let value = |c: u8| match c {
        b'A'..=b'Z' => c - b'A',
        b'a'..=b'z' => c - b'a' + 26,
        b'0'..=b'9' => c - b'0' + 52,
        b'+' => 62,
        b'/' => 63,
        _ => panic!("{c} is no letter of base64"),
    };
    let letters: Vec<u8> = text.bytes().filter(|c| *c != b'=').map(value).collect();
    let mut out = Vec::new();
    for four in letters.chunks(4) {
        let all = four.iter().fold(0_u32, |n, v| n << 6 | u32::from(*v)) << (6 * (4 - four.len()));
        out.extend(&all.to_be_bytes()[1..four.len()]);
    }
    out
}

impl Seen {
    fn at(&self, x: f64, y: f64) -> [u8; 3] {
        self.pixels[y as usize * self.width + x as usize]
    }

    /// The share of a rectangle's pixels of which this holds.
    fn share(&self, [x, y, w, h]: [f64; 4], holds: impl Fn([u8; 3]) -> bool) -> f64 {
        let (mut all, mut found) = (0.0, 0.0);
        for row in y as usize..(y + h) as usize {
            for column in x as usize..(x + w) as usize {
                all += 1.0;
                found += f64::from(u8::from(holds(self.pixels[row * self.width + column])));
            }
        }
        found / all
    }
}

fn white(p: [u8; 3]) -> bool {
    p == [255; 3]
}

fn red(p: [u8; 3]) -> bool {
    p[0] > 150 && p[1] < 110 && p[2] < 110
}

/// A camera in front of (15, 15, 30) that looks along +y from 200 mm away.
fn front_close(more: Value) -> Value {
    let mut call = json!({
        "assembly": "a", "eye_mm": [15, -185, 30], "target_mm": [15, 15, 30],
    });
    call.as_object_mut()
        .unwrap()
        .extend(more.as_object().unwrap().clone());
    call
}

/// Where that camera shows a point of the plane y = 15: the panel is the picture without the legend's
/// one row of 27 pixels, 60 pixels of it are for axes, 30 for the title; a lens of 40 degrees sees
/// 2 tan(20 degrees) 200 mm = 145.5881 mm of its height.
fn close_pixel([x, z]: [f64; 2]) -> [f64; 2] {
    let panel = 768.0 - 27.0;
    let scale = panel / 145.588_1;
    let middle = 30.0 + (panel - 90.0) / 2.0;
    [512.0 + (x - 15.0) * scale, middle - (z - 30.0) * scale]
}

/// A rectangle of the picture between two corners of the plane y = 15, shrunk by two pixels.
fn region(low: [f64; 2], high: [f64; 2]) -> [f64; 4] {
    let ([x0, y1], [x1, y0]) = (close_pixel(low), close_pixel(high));
    [x0 + 2.0, y0 + 2.0, x1 - x0 - 4.0, y1 - y0 - 4.0]
}

/// A block of 10 mm on a face of one of 30 mm.
fn two_blocks(face: &str, gap: f64) -> Kit {
    let mut kit = Kit::new();
    kit.new_assembly("a");
    kit.part("a", "base", "test.block", json!({"size": 30}));
    kit.part("a", "small", "test.block", json!({"size": 10}));
    kit.mate(json!({
        "assembly": "a", "id": "m", "mate_type": "face_to_face",
        "base": format!("base:{face}"), "incoming": "small:bottom", "d_n_mm": gap,
    }));
    kit
}

#[test]
fn a_floating_part_and_one_on_the_wrong_side_are_seen() {
    let right = render(&mut two_blocks("top", 0.0), front_close(json!({})));
    let floating = render(&mut two_blocks("top", 4.0), front_close(json!({})));
    let below = render(&mut two_blocks("bottom", 0.0), front_close(json!({})));
    assert_eq!((right.width, right.height), (1024, 768));
    // Where the small block stands when it is right: x from 10 to 20, z from 30 to 40.
    let stands = region([10.0, 30.0], [20.0, 40.0]);
    assert_eq!(right.share(stands, white), 0.0);
    // Floating 4 mm above it leaves these 4 mm free, and reaches 4 mm higher.
    let gap = region([10.0, 30.0], [20.0, 34.0]);
    let top = region([10.0, 40.0], [20.0, 44.0]);
    assert_eq!(
        (floating.share(gap, white), right.share(gap, white)),
        (1.0, 0.0)
    );
    assert_eq!(
        (floating.share(top, white), right.share(top, white)),
        (0.0, 1.0)
    );
    // On the wrong side: below the base, z from -10 to 0, and nothing above.
    let under = region([10.0, -10.0], [20.0, 0.0]);
    assert_eq!(
        (below.share(under, white), right.share(under, white)),
        (0.0, 1.0)
    );
    assert_eq!(below.share(stands, white), 1.0);
    // The base is the same in all three, pixel by pixel.
    let [x, y] = close_pixel([15.0, 15.0]);
    assert_eq!(
        (right.at(x, y), floating.at(x, y)),
        (below.at(x, y), below.at(x, y))
    );
    let colors: BTreeSet<[u8; 3]> = [[15.0, 15.0], [15.0, 35.0]]
        .map(close_pixel)
        .map(|[x, y]| right.at(x, y))
        .into();
    assert_eq!(colors.len(), 2, "each part has its colour");
}

#[test]
fn a_clash_is_red_where_it_is() {
    // The small block sinks 4 mm into the base.
    let mut kit = two_blocks("top", -4.0);
    kit.part("a", "far", "test.block", json!({"size": 10}));
    kit.mate(json!({
        "assembly": "a", "id": "f", "mate_type": "face_to_face",
        "base": "base:top", "incoming": "far:bottom", "u_mm": 30,
    }));
    let plain = render(&mut kit, front_close(json!({})));
    assert_eq!(plain.share([0.0, 0.0, 1024.0, 640.0], red), 0.0);
    let pair = render(
        &mut kit,
        front_close(json!({"highlight": ["small", "base"]})),
    );
    // x from 10 to 20, z from 26 to 30: in glass, so behind the base's front all of it is seen.
    assert!(pair.share(region([10.0, 26.0], [20.0, 30.0]), red) > 0.95);
    for (low, high) in [
        ([0.0, 0.0], [30.0, 25.0]),
        ([10.0, 31.0], [20.0, 36.0]),
        ([31.0, 30.0], [60.0, 50.0]),
    ] {
        assert!(pair.share(region(low, high), red) < 0.001, "{low:?}");
    }
    // 10 x 10 x 4 mm.
    assert!(
        pair.caption.contains("in both: 400 mm3"),
        "{}",
        pair.caption
    );
    // A pair that only touches has nothing in common, and says so.
    let touching = render(&mut kit, front_close(json!({"highlight": ["far", "base"]})));
    assert_eq!(touching.share([0.0, 0.0, 1024.0, 640.0], red), 0.0);
    assert!(
        touching.caption.contains("nothing in both"),
        "{}",
        touching.caption
    );
    // Cut through the middle, the material of both is red too.
    let cut = render(
        &mut kit,
        front_close(json!({"section_axis": "y", "section_offset_mm": 15})),
    );
    assert!(cut.share(region([10.0, 26.0], [20.0, 30.0]), red) > 0.9);
    assert_eq!(cut.share(region([0.0, 0.0], [30.0, 25.0]), red), 0.0);
}

#[test]
fn a_section_shows_what_is_inside() {
    let mut kit = Kit::new();
    kit.whole_stand("a");
    let call = |more: Value| {
        let mut call = json!({"assembly": "a", "views": ["right"]});
        call.as_object_mut()
            .unwrap()
            .extend(more.as_object().unwrap().clone());
        call
    };
    let whole = render(&mut kit, call(json!({})));
    let cut = render(&mut kit, call(json!({"section_axis": "x"})));
    assert!(cut.caption.contains("cut at x = 0 mm"), "{}", cut.caption);
    // From outside the block's side is one colour; inside are ring, shaft and bore.
    let shades = |seen: &Seen| {
        let all = seen.pixels.iter().map(|p| p.map(|c| c / 16));
        all.collect::<BTreeSet<_>>().len()
    };
    assert!(
        shades(&cut) > shades(&whole) + 10,
        "{} {}",
        shades(&cut),
        shades(&whole)
    );
    // A plane that misses everything leaves everything, or nothing.
    let beyond = render(
        &mut kit,
        call(json!({"section_axis": "x", "section_offset_mm": 900})),
    );
    let title = 30 * whole.width..700 * whole.width;
    assert!(beyond.pixels[title.clone()] == whole.pixels[title.clone()]);
    let empty = render(
        &mut kit,
        call(json!({"section_axis": "x", "section_offset_mm": -900})),
    );
    let seen = empty.pixels[title].iter().filter(|p| !white(**p)).count();
    assert!(seen < 2000, "axes and scale alone: {seen}");
}

#[test]
fn parts_are_drawn_apart_and_ports_shown() {
    let mut kit = two_blocks("top", 0.0);
    let exploded = render(&mut kit, front_close(json!({"explode": 1})));
    // The assembly's diagonal is that of 30 x 30 x 40; the gap is 6 percent of it.
    let gap = 0.06 * (900.0_f64 + 900.0 + 1600.0).sqrt();
    assert!(exploded.share(region([10.0, 30.0], [20.0, 30.0 + gap]), white) > 0.99);
    assert_eq!(
        exploded.share(region([10.0, 30.0 + gap], [20.0, 40.0]), white),
        0.0
    );
    // A port's z axis is blue, and points out of the face.
    let ports = render(&mut kit, front_close(json!({"ports": true})));
    let plain = render(&mut kit, front_close(json!({})));
    let [x, y] = close_pixel([15.0, 40.0]);
    // Faint where the block's front face hides the port's origin.
    let blue = |p: [u8; 3]| i32::from(p[2]) - i32::from(p[0]) > 40;
    let axis = [x - 2.0, y - 20.0, 4.0, 12.0];
    assert!(ports.share(axis, blue) > 0.2 && plain.share(axis, blue) == 0.0);
    let frames = render(&mut kit, front_close(json!({"frames": true})));
    let [x, y] = close_pixel([0.0, 0.0]);
    let axis = [x - 2.0, y - 36.0, 4.0, 30.0];
    assert!(frames.share(axis, blue) > 0.2);
    assert_eq!(plain.share(axis, blue), 0.0);
}

#[test]
fn what_is_missing_is_said_and_the_rest_is_drawn() {
    let mut kit = two_blocks("top", 0.0);
    let whole = render(&mut kit, front_close(json!({})));
    assert!(
        whole.caption.contains("All parts are shown."),
        "{}",
        whole.caption
    );
    kit.part("a", "lost", "test.block", json!({"size": 12}));
    let without = render(&mut kit, front_close(json!({})));
    assert!(
        without
            .caption
            .contains("not shown: lost: no mate joins it to the root"),
        "{}",
        without.caption
    );
    assert!(!without.caption.contains("All parts"));
    // In the picture too: the note is dark red, below the panel.
    let note = |p: [u8; 3]| p == [168, 20, 20];
    let below = [0.0, 700.0, 1024.0, 68.0];
    assert!(without.share(below, note) > 0.0 && whole.share(below, note) == 0.0);
    // A part that cannot be made, as in a specification from elsewhere.
    let file = kit.file("assemblies/a/assembly.yaml");
    let text = std::fs::read_to_string(&file).unwrap();
    assert!(text.contains("size: 12"), "{text}");
    std::fs::write(&file, text.replace("size: 12", "size: 1200")).unwrap();
    let unmade = render(&mut kit, front_close(json!({})));
    assert!(
        unmade
            .caption
            .contains("not shown: lost: it could not be made"),
        "{}",
        unmade.caption
    );
    assert!(unmade.pixels[..640 * 1024] == without.pixels[..640 * 1024]);
    std::fs::write(&file, text).unwrap();
    let d = kit.refusal(
        "render",
        json!({"assembly": "a", "highlight": ["base", "lost"]}),
    );
    assert_eq!(
        (&d["code"], &d["where"]),
        (&json!("unconnected"), &json!("highlight"))
    );
}

#[test]
fn the_same_picture_is_the_same_bytes() {
    let call = json!({
        "assembly": "stand", "views": ["isometric", "front", "top"], "ports": true, "explode": 0.5,
        "section_axis": "x", "width_px": 800, "height_px": 500,
    });
    let pair = json!({"assembly": "stand", "highlight": ["bearing", "block"], "width_px": 400, "height_px": 300});
    let mut files: [BTreeSet<Vec<u8>>; 2] = Default::default();
    for workers in ["1", "2"] {
        let mut kit = Kit::with(&["--workers", workers]);
        kit.stand("stand");
        for _ in 0..2 {
            for (files, call) in files.iter_mut().zip([&call, &pair]) {
                files.insert(render(&mut kit, call.clone()).png);
            }
        }
        // By another process over the same folder, the solids from disk.
        let mut kit = kit.killed_and_started_again();
        for (files, call) in files.iter_mut().zip([&call, &pair]) {
            files.insert(render(&mut kit, call.clone()).png);
        }
    }
    assert_eq!(files.map(|f| f.len()), [1, 1]);
}

#[test]
fn a_picture_is_left_as_a_file_when_asked_for() {
    let mut kit = two_blocks("top", 0.0);
    let before = kit.files();
    render(&mut kit, json!({"assembly": "a"}));
    assert_eq!(kit.files(), before, "nothing is written unasked");
    let seen = render(
        &mut kit,
        json!({"assembly": "a", "file": true, "views": ["top"]}),
    );
    let bytes = std::fs::read(kit.file("assemblies/a/a-top.png")).unwrap();
    assert_eq!(bytes, seen.png);
    let said = format!("File: assemblies/a/a-top.png ({} bytes).", bytes.len());
    assert!(seen.caption.contains(&said), "{}", seen.caption);
}

#[test]
fn wrong_requests_are_refused_with_what_would_do() {
    let mut kit = two_blocks("top", 0.0);
    let mut refused = |call: Value| {
        let mut whole = json!({"assembly": "a"});
        whole
            .as_object_mut()
            .unwrap()
            .extend(call.as_object().unwrap().clone());
        let d = kit.refusal("render", whole);
        (
            d["code"].as_str().unwrap().to_owned(),
            d["where"].as_str().unwrap().to_owned(),
        )
    };
    let wrong = |place: &str| ("argument_invalid".to_owned(), place.to_owned());
    let z = [0, 0, 1];
    assert_eq!(
        refused(json!({"camera_direction": z})),
        wrong("camera_direction"),
        "along its up"
    );
    assert_eq!(
        refused(json!({"camera_direction": [0, 0, 0]})),
        wrong("camera_direction")
    );
    assert_eq!(
        refused(json!({"camera_direction": [1, 0, 0], "views": ["top"]})),
        wrong("views")
    );
    assert_eq!(
        refused(json!({"camera_direction": [1, 0, 0], "eye_mm": z})),
        wrong("camera_direction")
    );
    assert_eq!(refused(json!({"camera_up": z})), wrong("camera_up"));
    assert_eq!(refused(json!({"eye_mm": z})), wrong("target_mm"));
    assert_eq!(refused(json!({"target_mm": z})), wrong("eye_mm"));
    assert_eq!(
        refused(json!({"eye_mm": z, "target_mm": z})),
        wrong("eye_mm")
    );
    assert_eq!(
        refused(json!({"section_offset_mm": 3})),
        wrong("section_axis")
    );
    assert_eq!(refused(json!({"width_px": 2001})), wrong("width_px"));
    assert_eq!(
        refused(json!({"highlight": ["base", "base"]})),
        wrong("highlight")
    );
    assert_eq!(
        refused(json!({"highlight": ["base", "small"], "explode": 1})),
        wrong("explode")
    );
    assert_eq!(refused(json!({"views": ["upside"]})).0, "argument_invalid");
    let unknown = refused(json!({"highlight": ["base", "smal"]}));
    assert_eq!(unknown, ("part_unknown".to_owned(), "highlight".to_owned()));
    kit.new_assembly("empty");
    let d = kit.refusal("render", json!({"assembly": "empty"}));
    assert_eq!(d["code"], "assembly_empty");
}

#[test]
fn the_server_lists_the_tool_without_a_schema_of_its_answer() {
    let root = tempfile::tempdir().unwrap();
    let mut session = crate::harness::Session::start(program(), root.path(), &[]).unwrap();
    let tools = session.request("tools/list", json!({})).unwrap();
    let tools = tools["result"]["tools"].as_array().unwrap();
    for tool in tools {
        let picture = tool["name"] == "render";
        assert_eq!(
            tool.get("outputSchema").is_none(),
            picture,
            "{}",
            tool["name"]
        );
    }
}

/// How long pictures take: the first one has its triangles made, the next one finds them in the worker.
#[test]
#[ignore = "prints figures for docs/measurements.md"]
fn timings() {
    let mut kit = Kit::with(&["--workers", "1"]);
    kit.whole_stand("stand");
    kit.new_assembly("gears");
    for (part, teeth) in [("pinion", 20), ("wheel", 40)] {
        kit.part(
            "gears",
            part,
            "gear.spur",
            json!({"module": 2, "teeth": teeth, "width": 15}),
        );
    }
    kit.mate(json!({
        "assembly": "gears", "id": "m", "mate_type": "gear_mesh",
        "base": "pinion:mesh_point", "incoming": "wheel:mesh_point",
    }));
    for call in [
        json!({"assembly": "stand"}),
        json!({"assembly": "stand", "section_axis": "x"}),
        json!({"assembly": "stand", "views": ["isometric", "front", "right", "top"], "width_px": 2000, "height_px": 2000}),
        json!({"assembly": "gears"}),
    ] {
        let took: Vec<String> = (0..3)
            .map(|_| {
                let start = std::time::Instant::now();
                let answer = kit.session.call("render", call.clone()).unwrap();
                let took = start.elapsed().as_secs_f64();
                let size = answer.blocks[1]["data"].as_str().unwrap().len() * 3 / 4;
                format!("{took:.2} s, {size} bytes")
            })
            .collect();
        println!("{call}: {}", took.join("; "));
    }
}
