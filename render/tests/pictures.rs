//! What pictures show, held against what is known of boxes.
#![cfg(test)]

use std::sync::Arc;

use assemcad_model::frame::{Frame, Placement};
use assemcad_render::{
    ALARM, Body, Entry, Eye, Look, Mark, Panel, Picture, RenderError, Sheet, Surface, View, draw,
};

const VIEWS: [View; 7] = [
    View::Isometric,
    View::Front,
    View::Back,
    View::Left,
    View::Right,
    View::Top,
    View::Bottom,
];

const BLUE: [f64; 3] = [0.2, 0.3, 0.9];
const GREEN: [f64; 3] = [0.2, 0.7, 0.2];
const ORANGE: [f64; 3] = [0.9, 0.6, 0.1];

/// A box between two corners: six faces of two triangles, twelve edges.
fn cuboid(low: [f64; 3], high: [f64; 3]) -> Surface {
    let mut s = Surface::default();
    for axis in 0..3 {
        let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
        for (side, level) in [(-1.0, low[axis]), (1.0, high[axis])] {
            let corner = |p: f64, q: f64| {
                let mut c = [0.0; 3];
                c[axis] = level;
                c[u] = p;
                c[v] = q;
                c
            };
            let ring = [
                corner(low[u], low[v]),
                corner(high[u], low[v]),
                corner(high[u], high[v]),
                corner(low[u], high[v]),
            ];
            let first = s.positions.len() as u32;
            let mut normal = [0.0; 3];
            normal[axis] = side;
            s.positions.extend(ring);
            s.normals.extend([normal; 4]);
            // u, v and the axis are right-handed: the ring turns left seen from the high side.
            let turned = |t: [u32; 3]| if side > 0.0 { t } else { [t[0], t[2], t[1]] };
            s.triangles.push(turned([first, first + 1, first + 2]));
            s.triangles.push(turned([first, first + 2, first + 3]));
            let [a, b, c, d] = ring;
            s.edges.push(vec![a, b, c, d, a]);
        }
    }
    s
}

fn body(low: [f64; 3], high: [f64; 3], color: [f64; 3]) -> Body {
    Body {
        surface: Arc::new(cuboid(low, high)),
        placement: Placement::IDENTITY,
        color,
        look: Look::Solid,
        fit: true,
    }
}

fn panel(eye: Eye, bodies: Vec<Body>) -> Panel {
    Panel {
        title: "test".to_owned(),
        eye,
        bodies,
        marks: Vec::new(),
        in_place: true,
    }
}

fn sheet(panels: Vec<Panel>) -> Sheet {
    Sheet {
        width: 1000,
        height: 800,
        panels,
        legend: Vec::new(),
        notes: Vec::new(),
    }
}

fn seen(view: View, bodies: Vec<Body>) -> Picture {
    draw(&sheet(vec![panel(view.eye(), bodies)])).unwrap()
}

/// Columns and rows of the pixels of which this holds, between title and axes.
fn pixels(picture: &Picture, holds: impl Fn([u8; 3]) -> bool) -> Vec<(f64, f64)> {
    let all = picture.pixels.iter().enumerate();
    all.map(|(i, p)| ((i % 1000) as f64 + 0.5, (i / 1000) as f64 + 0.5, *p))
        .filter(|(_, y, p)| (28.0..741.0).contains(y) && holds(*p))
        .map(|(x, y, _)| (x, y))
        .collect()
}

/// Of a hue: brightness aside, the colour is this one.
fn like(color: [f64; 3]) -> impl Fn([u8; 3]) -> bool {
    move |p| {
        let p = p.map(f64::from);
        let sum: f64 = p.iter().sum::<f64>().max(1.0);
        let whole: f64 = color.iter().sum();
        p.iter()
            .zip(color)
            .all(|(p, c)| (p / sum - c / whole).abs() < 0.06)
    }
}

fn mean(of: &[(f64, f64)]) -> (f64, f64) {
    let n = of.len() as f64;
    let sum = of.iter().fold((0.0, 0.0), |(a, b), (x, y)| (a + x, b + y));
    (sum.0 / n, sum.1 / n)
}

#[test]
fn every_view_shows_the_silhouette_of_a_box() {
    let (a, b, c) = (60.0_f64, 40.0_f64, 25.0_f64);
    let across = (
        (a + b) / 2.0_f64.sqrt(),
        (a + b) / 6.0_f64.sqrt() + c * (2.0_f64 / 3.0).sqrt(),
    );
    for view in VIEWS {
        // Width, height and area of the silhouette in mm and mm2.
        let (wide, high, area) = match view {
            View::Front | View::Back => (a, c, a * c),
            View::Left | View::Right => (b, c, b * c),
            View::Top | View::Bottom => (a, b, a * b),
            View::Isometric => (across.0, across.1, (a * b + b * c + c * a) / 3.0_f64.sqrt()),
        };
        let picture = seen(
            view,
            vec![body([3.0, -7.0, 11.0], [3.0 + a, -7.0 + b, 11.0 + c], BLUE)],
        );
        let covered = pixels(&picture, |p| p != [255; 3]);
        let span = |pick: fn(&(f64, f64)) -> f64| {
            let all = covered.iter().map(pick);
            let (low, high) = all.fold((f64::MAX, f64::MIN), |(l, h), x| (l.min(x), h.max(x)));
            high - low + 1.0
        };
        let (px_wide, px_high) = (span(|p| p.0), span(|p| p.1));
        let scale = px_wide / wide;
        // As large as there is room for.
        assert!(px_wide > 900.0 || px_high > 690.0, "{view:?}");
        assert!((px_high / scale / high - 1.0).abs() < 0.01, "{view:?}");
        let found = covered.len() as f64 / (scale * scale);
        assert!(
            (found / area - 1.0).abs() < 0.01,
            "{view:?}: {found} {area}"
        );
        // What the picture says of its scale is so.
        let told = picture.shown[0].camera.px_per_mm;
        assert!(
            (told / scale - 1.0).abs() < 0.01,
            "{view:?}: {told} {scale}"
        );
        // The middle of the box is in the middle of its silhouette.
        let [x, y] = picture.shown[0].pixel([3.0 + a / 2.0, -7.0 + b / 2.0, 11.0 + c / 2.0]);
        let middle = mean(&covered);
        assert!(
            (x - middle.0).abs() < 1.0 && (y - middle.1).abs() < 1.0,
            "{view:?}"
        );
    }
}

#[test]
fn views_stand_as_on_a_drawing() {
    // A grey cube with a block on each of its sides +x, +y and +z.
    let bodies = || {
        vec![
            body([-10.0; 3], [10.0; 3], [0.5; 3]),
            body([10.0, -3.0, -3.0], [20.0, 3.0, 3.0], ORANGE),
            body([-3.0, 10.0, -3.0], [3.0, 20.0, 3.0], GREEN),
            body([-3.0, -3.0, 10.0], [3.0, 3.0, 20.0], BLUE),
        ]
    };
    // Where x, y and z point in the picture: to the right and up; nothing where they point along the view.
    let table = [
        (View::Front, Some((1, 0)), None, Some((0, 1))),
        (View::Back, Some((-1, 0)), None, Some((0, 1))),
        (View::Left, None, Some((-1, 0)), Some((0, 1))),
        (View::Right, None, Some((1, 0)), Some((0, 1))),
        (View::Top, Some((1, 0)), Some((0, 1)), None),
        (View::Bottom, Some((1, 0)), Some((0, -1)), None),
        (View::Isometric, Some((1, -1)), Some((1, 1)), Some((0, 1))),
    ];
    for (view, x, y, z) in table {
        let picture = seen(view, bodies());
        let [cx, cy] = picture.shown[0].pixel([0.0; 3]);
        for (color, way) in [(ORANGE, x), (GREEN, y), (BLUE, z)] {
            let Some((right, up)) = way else { continue };
            let found = pixels(&picture, like(color));
            assert!(found.len() > 500, "{view:?} {color:?}");
            let (mx, my) = mean(&found);
            let sign = |d: f64| if d.abs() < 12.0 { 0 } else { d.signum() as i32 };
            assert_eq!(
                (sign(mx - cx), sign(cy - my)),
                (right, up),
                "{view:?} {color:?}"
            );
        }
    }
}

#[test]
fn what_is_behind_is_hidden() {
    let near = body([0.0, -20.0, 0.0], [10.0, -10.0, 10.0], ORANGE);
    let far = body([0.0, 10.0, 0.0], [10.0, 20.0, 10.0], GREEN);
    for bodies in [
        vec![near.clone(), far.clone()],
        vec![far.clone(), near.clone()],
    ] {
        let front = seen(View::Front, bodies.clone());
        assert!(pixels(&front, like(GREEN)).is_empty());
        assert!(pixels(&front, like(ORANGE)).len() > 100_000);
        assert!(pixels(&seen(View::Back, bodies), like(ORANGE)).is_empty());
    }
    // In glass it is seen.
    let glass = Body {
        look: Look::Glass,
        ..near
    };
    let red = Body {
        color: ALARM,
        ..body([3.0, -17.0, 3.0], [7.0, -13.0, 7.0], ALARM)
    };
    let picture = seen(View::Front, vec![glass, red]);
    let [x, y] = picture.shown[0].pixel([5.0, -20.0, 5.0]);
    let [r, g, b] = picture.pixels[y as usize * 1000 + x as usize];
    assert!(r > 180 && g < 120 && b < 90, "{r} {g} {b}");
    let [x, y] = picture.shown[0].pixel([1.0, -20.0, 5.0]);
    let [r, g, b] = picture.pixels[y as usize * 1000 + x as usize];
    assert!(g > 150 && r > g && g > b, "{r} {g} {b}");
}

#[test]
fn cut_material_is_hatched_and_twofold_material_is_red() {
    // Two plates whose top faces are cut; they overlap over 10 of 30 mm.
    let cut = |low: [f64; 3], high: [f64; 3], color| {
        let mut surface = cuboid(low, high);
        surface.cut = surface
            .triangles
            .iter()
            .map(|t| {
                t.iter()
                    .all(|i| surface.normals[*i as usize] == [0.0, 0.0, 1.0])
            })
            .collect();
        Body {
            surface: Arc::new(surface),
            ..body(low, high, color)
        }
    };
    let left = cut([0.0; 3], [20.0, 20.0, 5.0], BLUE);
    let right = |from: f64| cut([from, 0.0, 0.0], [30.0, 20.0, 5.0], GREEN);
    for order in [[0, 1], [1, 0]] {
        let both = [left.clone(), right(10.0)];
        let picture = seen(View::Top, order.map(|i: usize| both[i].clone()).to_vec());
        let scale = picture.shown[0].camera.px_per_mm;
        let red = pixels(&picture, like(ALARM));
        let area = red.len() as f64 / (scale * scale);
        assert!((area / 200.0 - 1.0).abs() < 0.05, "{area}");
        let [x, y] = picture.shown[0].pixel([15.0, 10.0, 5.0]);
        let (mx, my) = mean(&red);
        assert!((mx - x).abs() < 2.0 && (my - y).abs() < 2.0);
        // Hatched: about a fifth of the cut is dark lines.
        let strip = |p: &(f64, f64)| {
            let [x0, y0] = picture.shown[0].pixel([1.0, 19.0, 5.0]);
            let [x1, y1] = picture.shown[0].pixel([9.0, 1.0, 5.0]);
            (x0..x1).contains(&p.0) && (y0..y1).contains(&p.1)
        };
        let dark = pixels(&picture, |[r, g, b]| {
            u32::from(r) + u32::from(g) + u32::from(b) < 330
        });
        let all = pixels(&picture, |_| true);
        let share = dark.iter().filter(|p| strip(p)).count() as f64
            / all.iter().filter(|p| strip(p)).count() as f64;
        assert!((0.05..0.4).contains(&share), "{share}");
    }
    // Drawn apart, what lies in one place is no overlap.
    let mut apart = panel(View::Top.eye(), vec![left.clone(), right(10.0)]);
    apart.in_place = false;
    let apart = draw(&sheet(vec![apart])).unwrap();
    assert_eq!(pixels(&apart, like(ALARM)), []);
    // Side by side nothing is red, nor where they reach into each other by less than a pixel.
    for from in [20.0, 19.98] {
        let picture = seen(View::Top, vec![left.clone(), right(from)]);
        assert_eq!(pixels(&picture, like(ALARM)), [], "{from}");
    }
}

fn full() -> Sheet {
    let mut sheet = sheet(
        VIEWS
            .map(|v| panel(v.eye(), vec![body([0.0; 3], [9.0, 5.0, 2.0], BLUE)]))
            .to_vec(),
    );
    sheet.panels[0].marks.push(Mark {
        frame: Frame::WORLD,
        label: "part:port".to_owned(),
        large: false,
    });
    sheet.legend.push(Entry {
        color: ORANGE,
        label: "a bracket".to_owned(),
    });
    sheet.notes.push("not shown: a bolt".to_owned());
    sheet
}

#[test]
fn the_file_holds_the_pixels_and_is_the_same_every_time() {
    let first = draw(&full()).unwrap();
    let again = std::thread::spawn(|| draw(&full()).unwrap())
        .join()
        .unwrap();
    assert_eq!(first.png, again.png);
    let mut reader = png::Decoder::new(std::io::Cursor::new(&first.png))
        .read_info()
        .unwrap();
    let mut bytes = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut bytes).unwrap();
    assert_eq!((info.width, info.height), (1000, 800));
    assert_eq!(bytes, first.pixels.as_flattened());
    // Nothing but the picture is in the file: no time, no text.
    for chunk in [b"tEXt", b"tIME", b"iTXt", b"zTXt"] {
        assert!(!first.png.windows(4).any(|w| w == chunk));
    }
}

#[test]
fn legend_notes_and_marks_are_there() {
    let whole = draw(&full()).unwrap();
    let row = |y: usize, holds: &dyn Fn([u8; 3]) -> bool| {
        whole.pixels[y * 1000..(y + 1) * 1000]
            .iter()
            .filter(|p| holds(**p))
            .count()
    };
    let below = |holds: &dyn Fn([u8; 3]) -> bool| (750..800).map(|y| row(y, holds)).sum::<usize>();
    // The square of the legend, and the words of the note, are where they belong.
    assert!(
        (75..=90).contains(&below(&|p| p == [230, 153, 26])),
        "9 x 9 pixels"
    );
    assert!(below(&|p| p == [168, 20, 20]) > 60);
    let mut without = full();
    without.panels[0].marks.clear();
    let without = draw(&without).unwrap();
    let changed: Vec<usize> = (0..whole.pixels.len())
        .filter(|i| whole.pixels[*i] != without.pixels[*i])
        .collect();
    let [x, y] = whole.shown[0].pixel([0.0; 3]);
    assert!(changed.len() > 100);
    for i in changed {
        let (dx, dy) = ((i % 1000) as f64 - x, (i / 1000) as f64 - y);
        assert!(dx.abs() < 90.0 && dy.abs() < 30.0, "{dx} {dy}");
    }
}

#[test]
fn a_crowded_legend_says_what_it_leaves_out() {
    let mut sheet = full();
    sheet.panels.truncate(1);
    for i in 0..500 {
        sheet.legend.push(Entry {
            color: GREEN,
            label: format!("part number {i}"),
        });
    }
    let picture = draw(&sheet).unwrap();
    // A quarter of the sheet at most is legend.
    let [_, y] = picture.shown[0].camera.size;
    assert!(y >= 590.0, "{y}");
}

#[test]
fn views_on_one_sheet_have_one_scale_and_an_aimed_camera_its_own() {
    let bodies = || vec![body([0.0; 3], [90.0, 30.0, 10.0], BLUE)];
    let aim = Eye {
        aim: Some(([90.0, 0.0, 10.0], 20.0)),
        ..View::Front.eye()
    };
    let panels = vec![
        panel(View::Top.eye(), bodies()),
        panel(View::Right.eye(), bodies()),
        panel(aim, bodies()),
    ];
    let picture = draw(&sheet(panels)).unwrap();
    let [a, b, c] = [0, 1, 2].map(|i: usize| picture.shown[i].camera);
    assert_eq!(a.px_per_mm, b.px_per_mm);
    assert_eq!(c.px_per_mm, 400.0 / 20.0);
    let [x, y] = picture.shown[2].pixel([90.0, 0.0, 10.0]);
    assert!(
        (x - 250.0).abs() < 1.0 && (560.0..640.0).contains(&y),
        "{x} {y}"
    );
}

#[test]
fn what_is_no_picture_is_refused() {
    let mut small = full();
    small.width = 100;
    assert_eq!(draw(&small), Err(RenderError::Size));
    let mut large = full();
    large.height = 2001;
    assert_eq!(draw(&large), Err(RenderError::Size));
    assert_eq!(draw(&sheet(Vec::new())), Err(RenderError::Panels));
    for (toward, up) in [
        ([0.0; 3], [0.0, 0.0, 1.0]),
        ([0.0, 0.0, 2.0], [0.0, 0.0, -1.0]),
    ] {
        let eye = Eye {
            toward,
            up,
            aim: None,
        };
        assert_eq!(
            draw(&sheet(vec![panel(eye, Vec::new())])),
            Err(RenderError::Camera)
        );
    }
    // Nothing to see is a picture all the same.
    assert!(draw(&sheet(vec![panel(View::Top.eye(), Vec::new())])).is_ok());
}
