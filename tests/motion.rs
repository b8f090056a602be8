//! Sweeps over the real protocol, against closed forms.

use serde_json::{Value, json};

use crate::kit::{Kit, near};

/// How near the witness is to the first touch: the bisection's tolerance, and what a common volume of tau takes.
const WITNESS_DEG: f64 = 0.03;

fn boxes(list: &[[f64; 6]]) -> Vec<Value> {
    let of =
        |b: &[f64; 6]| json!({"x": b[0], "y": b[1], "z": b[2], "dx": b[3], "dy": b[4], "dz": b[5]});
    list.iter().map(of).collect()
}

fn ports(list: &[(f64, f64, f64, u32)]) -> Vec<Value> {
    let of = |p: &(f64, f64, f64, u32)| json!({"x": p.0, "y": p.1, "z": p.2, "side": p.3});
    list.iter().map(of).collect()
}

/// A part of boxes with ports at points on sides: +x, -x, +y, -y, +z, -z.
fn part(kit: &mut Kit, name: &str, list: &[[f64; 6]], at: &[(f64, f64, f64, u32)]) {
    kit.part(
        "m",
        name,
        "test.ways",
        json!({"boxes": boxes(list), "ports": ports(at)}),
    );
}

/// A hinge about z, the incoming part a millimetre above the base part.
fn hinge(kit: &mut Kit, id: &str, base: &str, incoming: &str, alpha_deg: f64) {
    kit.mate(json!({
        "assembly": "m", "id": id, "mate_type": "coaxial_face", "base": base, "incoming": incoming,
        "d_mm": 1, "alpha_deg": alpha_deg,
    }));
}

fn sweep(kit: &mut Kit, part: &str, more: Value) -> Value {
    let mut call = json!({"assembly": "m", "part": part});
    call.as_object_mut()
        .unwrap()
        .extend(more.as_object().unwrap().clone());
    kit.ok("sweep", call)
}

fn motion() -> Kit {
    let mut kit = Kit::new();
    kit.new_assembly("m");
    kit
}

/// A bar from the hinge to (60, +-5) turns towards a wall at y = 40.
fn bar_and_wall() -> Kit {
    let mut kit = motion();
    part(
        &mut kit,
        "ground",
        &[
            [-50.0, -50.0, -10.0, 150.0, 110.0, 10.0],
            [-50.0, 40.0, 0.0, 150.0, 20.0, 20.0],
        ],
        &[(0.0, 0.0, 0.0, 4)],
    );
    part(
        &mut kit,
        "bar",
        &[[-5.0, -5.0, 0.0, 65.0, 10.0, 5.0]],
        &[(0.0, 0.0, 0.0, 5)],
    );
    hinge(&mut kit, "pin", "ground:p1", "bar:p1", 0.0);
    kit
}

#[test]
fn a_bar_hits_a_wall_where_its_corner_reaches_it() {
    let mut kit = bar_and_wall();
    let found = sweep(&mut kit, "bar", json!({}));
    // The corner (60, 5): 60 sin t + 5 cos t = 40.
    let t = (libm::asin(40.0 / libm::hypot(60.0, 5.0)) - libm::atan2(5.0, 60.0)).to_degrees();
    let hit = &found["collision"];
    assert_eq!(
        (&found["verdict"], &found["unit"]),
        (&json!("fail"), &json!("deg")),
        "{found}"
    );
    assert!(near(&hit["at"], t, WITNESS_DEG), "{hit}, not {t}");
    // Where they are free they are, and the witness brackets the touch.
    let (at, until) = (
        hit["at"].as_f64().unwrap(),
        hit["free_until"].as_f64().unwrap(),
    );
    assert!(until < at && at - until <= 0.01 + 1e-6 && at > t && until > t - WITNESS_DEG);
    assert_eq!(
        (&hit["parts"], &hit["mates"]),
        (&json!(["ground", "bar"]), &json!(["pin"]))
    );
    assert!(hit["common_volume_mm3"].as_f64().unwrap() > 0.001);
    // The corner's place.
    assert!(near(&hit["centre_mm"][1], 40.0, 0.05), "{hit}");
    assert_eq!(found["direction"], json!([0.0, 0.0, 1.0]));
    // The other way round it comes to the wall as its mirror image would.
    let back = sweep(&mut kit, "bar", json!({"to_deg": -360, "step_deg": 7}));
    assert!(
        near(&back["collision"]["at"], -180.0 - t, WITNESS_DEG),
        "{}",
        back["collision"]
    );
    // Short of it there is none, and that is a sample only.
    let short = sweep(&mut kit, "bar", json!({"to_deg": t - 0.5}));
    assert_eq!(short["verdict"], "pass", "{short}");
    let pairs = &short["pairs"];
    assert_eq!(
        (&pairs["moving"], &pairs["sampled"]),
        (&json!(1), &json!(1))
    );
    assert_eq!(pairs["proven"], json!([]));
    assert!(short["kernel_asked"].as_u64().unwrap() >= 1);
    // From within: at once.
    let within = sweep(
        &mut kit,
        "bar",
        json!({"from_deg": t + 5.0, "to_deg": t + 9.0}),
    );
    assert!(near(&within["collision"]["at"], t + 5.0, 1e-5), "{within}");
    assert_eq!(within["collision"].get("free_until"), None);
    // The same bytes again.
    assert_eq!(sweep(&mut kit, "bar", json!({"to_deg": t - 0.5})), short);
}

/// The face y = 5 of a door comes onto the edge of its stop at (30, 30): the distance from the axis to the face's
/// line is 5, so that sqrt(1800) sin(45 - t) = 5.
#[test]
fn a_door_comes_onto_its_stop() {
    let mut kit = motion();
    part(
        &mut kit,
        "frame",
        &[
            [-50.0, -50.0, -10.0, 150.0, 130.0, 10.0],
            [10.0, 30.0, 0.0, 20.0, 20.0, 60.0],
        ],
        &[(0.0, 0.0, 0.0, 4)],
    );
    part(
        &mut kit,
        "door",
        &[[-5.0, 0.0, 0.0, 90.0, 5.0, 50.0]],
        &[(0.0, 2.5, 0.0, 5)],
    );
    kit.mate(json!({
        "assembly": "m", "id": "hinge", "mate_type": "coaxial_face", "base": "frame:p1", "incoming": "door:p1",
        "d_mm": 1,
    }));
    let found = sweep(&mut kit, "door", json!({"to_deg": 90}));
    // The hinge is in the middle of the door's thickness: 2.5 to its face.
    let t = 45.0 - libm::asin(2.5 / libm::sqrt(1800.0)).to_degrees();
    assert!(
        near(&found["collision"]["at"], t, WITNESS_DEG),
        "{found}, not {t}"
    );
    assert_eq!(found["collision"]["parts"], json!(["frame", "door"]));
}

/// Crank 20, rod 70, the slider between a floor and a side wall, all in layers; a wall at `wall` before the slider,
/// which reaches 10 before its pin. At first the crank stands at a right angle.
fn slider_crank(wall: f64) -> Kit {
    let (r, l) = (20.0, 70.0);
    let x = libm::sqrt(l * l - r * r);
    let mut kit = motion();
    part(
        &mut kit,
        "ground",
        &[
            [-60.0, -60.0, -10.0, 220.0, 120.0, 10.0],
            // The side of the slide, and the wall before it.
            [60.0, -40.0, 0.0, 70.0, 28.0, 30.0],
            [wall, -12.0, 0.0, 10.0, 40.0, 30.0],
        ],
        &[(0.0, 0.0, 0.0, 4), (x, 0.0, 0.0, 4), (x, -12.0, 5.0, 2)],
    );
    part(
        &mut kit,
        "crank",
        &[[-4.0, -4.0, 0.0, 8.0 + r, 8.0, 4.0]],
        &[(0.0, 0.0, 0.0, 5), (r, 0.0, 4.0, 4)],
    );
    part(
        &mut kit,
        "rod",
        &[[-4.0, -4.0, 0.0, 8.0 + l, 8.0, 4.0]],
        &[(0.0, 0.0, 0.0, 5), (l, 0.0, 4.0, 4)],
    );
    // Its pin is its own: it hangs over the rod, 1 + 4 + 1 + 4 + 1 above the floor.
    part(
        &mut kit,
        "slider",
        &[
            [-10.0, -10.0, 0.0, 20.0, 20.0, 4.0],
            [-10.0, -10.0, 0.0, 20.0, 2.0, 15.0],
            [-10.0, -10.0, 11.0, 20.0, 20.0, 4.0],
        ],
        &[
            (0.0, 0.0, 0.0, 5),
            (0.0, -10.0, 5.0, 3),
            (0.0, 0.0, 11.0, 5),
        ],
    );
    // A base port's z up turns the incoming part by -alpha.
    hinge(&mut kit, "main", "ground:p1", "crank:p1", -90.0);
    let rod = libm::atan2(-r, x).to_degrees();
    hinge(&mut kit, "big", "crank:p2", "rod:p1", 90.0 - rod);
    for (id, base, incoming) in [
        ("floor", "ground:p2", "slider:p1"),
        ("side", "ground:p3", "slider:p2"),
    ] {
        kit.mate(json!({
            "assembly": "m", "id": id, "mate_type": "face_to_face", "base": base, "incoming": incoming,
            "d_n_mm": if id == "side" { 2 } else { 0 },
        }));
    }
    hinge(&mut kit, "small", "rod:p2", "slider:p3", rod);
    kit
}

#[test]
fn a_slider_that_its_crank_pushes_hits_a_wall() {
    let (r, l, wall) = (20.0, 70.0, 92.0);
    let mut kit = slider_crank(wall);
    let found = sweep(&mut kit, "crank", json!({"to_deg": -90, "step_deg": 6}));
    // The pin at X = wall - 10: the law of cosines gives the crank's angle.
    let x = wall - 10.0;
    let t = libm::acos((r * r + x * x - l * l) / (2.0 * r * x)).to_degrees();
    let hit = &found["collision"];
    assert!(
        near(&hit["at"], t - 90.0, WITNESS_DEG),
        "{found}, not {}",
        t - 90.0
    );
    assert_eq!(hit["parts"], json!(["ground", "slider"]));
    // A wall behind the dead centre is never reached: the crank goes round.
    let mut kit = slider_crank(r + l + 10.5);
    let round = sweep(&mut kit, "crank", json!({"step_deg": 15}));
    assert_eq!(
        (&round["verdict"], &round["reached"]),
        (&json!("pass"), &json!(360.0)),
        "{round}"
    );
    assert_eq!(round["pairs"]["moving"], 6);
    // Driven by the slider it stops there.
    let way = r + l - libm::sqrt(l * l - r * r);
    let pushed = sweep(&mut kit, "slider", json!({"to_mm": way + 5.0}));
    assert_eq!(
        (&pushed["verdict"], pushed.get("collision")),
        (&json!("fail"), None),
        "{pushed}"
    );
    assert!(
        near(&pushed["stopped"]["at"], way, 1e-4),
        "{pushed}, not {way}"
    );
    assert!(
        pushed["stopped"]["why"]
            .as_str()
            .unwrap()
            .starts_with("blocked")
    );
    assert_eq!(pushed["direction"], json!([1.0, 0.0, 0.0]));
    // A range beyond it is not reached, and that is no sample.
    let beyond = sweep(
        &mut kit,
        "slider",
        json!({"from_mm": way + 1.0, "to_mm": way + 2.0}),
    );
    assert_eq!(
        (&beyond["verdict"], &beyond["pairs"]["sampled"]),
        (&json!("fail"), &json!(0)),
        "{beyond}"
    );
}

/// Shaft and bearings are round about their axis: nothing is left to samples.
#[test]
fn a_shaft_in_its_bearings_is_proven() {
    let mut kit = Kit::new();
    kit.whole_stand("m");
    let found = sweep(&mut kit, "shaft", json!({}));
    assert_eq!(
        (&found["verdict"], &found["reached"]),
        (&json!("pass"), &json!(360.0)),
        "{found}"
    );
    let pairs = &found["pairs"];
    assert_eq!(
        (&pairs["moving"], &pairs["sampled"]),
        (&json!(4), &json!(0)),
        "{found}"
    );
    let proven = pairs["proven"].as_array().unwrap();
    let by = |a: &str| {
        let both = [json!([a, "shaft"]), json!(["shaft", a])];
        let pair = proven.iter().find(|p| both.contains(&p["parts"]));
        pair.unwrap()["by"].clone()
    };
    assert_eq!([by("block"), by("bearing"), by("back")], ["revolution"; 3]);
    // The shaft may slide too; that stands still.
    let held = found["held_still"].as_array().unwrap();
    assert!(
        held.iter().any(|h| h.as_str().unwrap().contains("slide")),
        "{held:?}"
    );
    // Sliding is sampled.
    let slid = sweep(
        &mut kit,
        "shaft",
        json!({"kind": "slide", "to_mm": 4, "step_mm": 2}),
    );
    assert_eq!(slid["unit"], "mm");
    assert_eq!(slid["pairs"]["proven"], json!([]));
}

/// A disc about its own axis is proven, one beside it is not, and hits the post that it reaches.
#[test]
fn a_cam_is_sampled_and_a_disc_is_proven() {
    for (off, hits) in [(0.0, false), (3.0, true)] {
        let mut kit = motion();
        part(
            &mut kit,
            "ground",
            &[
                [-40.0, -40.0, -10.0, 80.0, 80.0, 10.0],
                [-4.0, 12.0, 0.0, 8.0, 8.0, 8.0],
            ],
            &[(0.0, 0.0, 0.0, 4)],
        );
        kit.part("m", "cam", "test.eccentric", json!({"off": off}));
        hinge(&mut kit, "axle", "ground:p1", "cam:under", 0.0);
        let found = sweep(&mut kit, "cam", json!({}));
        let pairs = &found["pairs"];
        if hits {
            assert_eq!(pairs["proven"], json!([]));
            // The disc's middle at 3 (cos t, sin t): its top at 3 sin t + 10 reaches 12 where x is within the post.
            let t = libm::asin(2.0 / 3.0).to_degrees();
            assert!(near(&found["collision"]["at"], t, 0.2), "{found}, not {t}");
        } else {
            assert_eq!(
                (&found["verdict"], &pairs["sampled"]),
                (&json!("pass"), &json!(0)),
                "{found}"
            );
            assert_eq!(pairs["proven"][0]["by"], "revolution");
            // Asked once for surfaces of each, once for the pose.
            assert_eq!(found["kernel_asked"], 3);
        }
    }
}

/// Two gears of 18 teeth of module 2, each tooth 0.1 mm thinner, on posts 36 mm apart; the second one turned, and
/// joined by their teeth or not. The play is 0.2 mm along the pitch circles.
fn gears(mesh: bool, turned: f64) -> Kit {
    let mut kit = motion();
    kit.part("m", "posts", "test.posts", json!({}));
    for (name, post, alpha) in [
        ("one", "posts:post_1", 0.0),
        ("two", "posts:post_2", turned),
    ] {
        kit.part(
            "m",
            name,
            "gear.spur",
            json!({"teeth": 18, "width": 5, "backlash_mm": 0.1}),
        );
        // From 1 to 6 mm above the plate.
        kit.mate(json!({
            "assembly": "m", "id": name, "mate_type": "coaxial", "base": post, "incoming": format!("{name}:bore"),
            "direction": "same", "d_mm": 2, "alpha_deg": alpha,
        }));
    }
    if mesh {
        kit.mate(json!({
            "assembly": "m", "id": "teeth", "mate_type": "gear_mesh",
            "base": "one:mesh_point", "incoming": "two:mesh_point",
        }));
    }
    kit
}

#[test]
fn gears_in_phase_turn_through_their_teeth_and_others_do_not() {
    // A tooth of the first is on the centre line; the second, of even teeth, is turned by half a pitch.
    let found = sweep(
        &mut gears(true, 10.0),
        "one",
        json!({"to_deg": 40, "step_deg": 2.5}),
    );
    assert_eq!(
        (&found["verdict"], &found["reached"]),
        (&json!("pass"), &json!(40.0)),
        "{found}"
    );
    let motion = found["motion"].as_str().unwrap();
    assert!(
        motion.contains("'two' turns about z through [36, 0, 0], -1 times"),
        "{motion}"
    );
    // Neither the gears nor the plate with its posts are round.
    assert_eq!(found["pairs"]["sampled"], 3, "{found}");
    // The same without the mate between them: the first turns alone and takes up half of the play.
    let alone = sweep(
        &mut gears(false, 10.0),
        "one",
        json!({"to_deg": 40, "step_deg": 2.5}),
    );
    let t = (0.1f64 / 18.0).to_degrees();
    let hit = &alone["collision"];
    assert!(
        near(&hit["at"], t, 0.05) && hit["at"].as_f64() > Some(t - 0.01),
        "{alone}, not {t}"
    );
    assert_eq!(hit["parts"], json!(["one", "two"]));
    // Tooth on tooth: at once.
    let clash = sweep(&mut gears(false, 0.0), "one", json!({"to_deg": 40}));
    assert_eq!(
        (&clash["verdict"], &clash["collision"]["at"]),
        (&json!("fail"), &json!(0.0)),
        "{clash}"
    );
}

#[test]
fn what_cannot_be_swept_is_refused() {
    let mut kit = bar_and_wall();
    let call = |more: Value| {
        let mut call = json!({"assembly": "m", "part": "bar"});
        call.as_object_mut()
            .unwrap()
            .extend(more.as_object().unwrap().clone());
        call
    };
    let held = kit.refusal("sweep", call(json!({"part": "ground"})));
    assert_eq!(held["code"], "part_held");
    assert_eq!(held["expected"]["parts_that_can_move"], json!(["bar"]));
    // Its next call goes.
    let next = held["next"]["arguments"].clone();
    assert_eq!(kit.ok("sweep", next)["verdict"], "fail");
    for (more, code, place) in [
        (json!({"part": "bard"}), "part_unknown", "part"),
        (json!({"kind": "slide", "to_mm": 5}), "part_held", "part"),
        (
            json!({"to_deg": 5, "to_mm": 5}),
            "argument_invalid",
            "arguments",
        ),
        (
            json!({"kind": "rotate", "to_mm": 5}),
            "argument_invalid",
            "kind",
        ),
        (json!({"to_deg": 0}), "argument_invalid", "to_deg"),
        (json!({"step_deg": 0.01}), "argument_invalid", "step_deg"),
        (json!({"step_deg": 0}), "argument_invalid", "step_deg"),
    ] {
        let d = kit.refusal("sweep", call(more.clone()));
        assert_eq!(
            (&d["code"], &d["where"]),
            (&json!(code), &json!(place)),
            "{more}: {d}"
        );
    }
    part(
        &mut kit,
        "loose",
        &[[0.0, 0.0, 0.0, 5.0, 5.0, 5.0]],
        &[(2.0, 2.0, 5.0, 4)],
    );
    assert_eq!(
        kit.refusal("sweep", call(json!({"part": "loose"})))["code"],
        "unconnected"
    );
}
