//! The four factories, measured by the kernel, against closed forms.

use core::f64::consts::PI;

use serde_json::{Value, json};

use crate::kit::{Kit, near};

/// Volume, centre and box of a part, each from a closed form.
struct Wanted {
    volume: f64,
    centre: [f64; 3],
    min: [f64; 3],
    max: [f64; 3],
}

fn check(factory: &str, cases: Vec<(Value, Wanted)>) {
    let mut kit = Kit::new();
    for (i, (params, wanted)) in cases.into_iter().enumerate() {
        let name = format!("a{i}");
        kit.new_assembly(&name);
        let part = kit.part(&name, "p", factory, params.clone());
        let told = format!("{factory} {params}: {part}");
        // The kernel integrates over curved faces numerically; its boxes are tight to 1e-6.
        assert!(
            near(
                &part["volume_mm3"],
                wanted.volume,
                wanted.volume * 1e-9 + 1e-6
            ),
            "{told}"
        );
        let report = kit.ok("verify", json!({"assembly": name, "detail": "full"}));
        assert_eq!(report["verdict"], "pass", "{told}");
        // The root stands at the origin: its centre in the world is that in its own frame.
        let centre = &report["measured"]["parts"][0]["centre_mm"];
        for k in 0..3 {
            assert!(near(&centre[k], wanted.centre[k], 2e-6), "{told}: {centre}");
            assert!(near(&part["box_min_mm"][k], wanted.min[k], 2e-6), "{told}");
            assert!(near(&part["box_max_mm"][k], wanted.max[k], 2e-6), "{told}");
        }
    }
}

#[test]
fn rect_plate() {
    let plate = |l: f64, w: f64, t: f64| {
        let wanted = Wanted {
            volume: l * w * t,
            centre: [0.0, 0.0, t / 2.0],
            min: [-l / 2.0, -w / 2.0, 0.0],
            max: [l / 2.0, w / 2.0, t],
        };
        (json!({"length": l, "width": w, "thickness": t}), wanted)
    };
    check(
        "base_frame.rect_plate",
        vec![plate(200.0, 120.0, 15.0), plate(33.3, 7.0, 1.25)],
    );
}

#[test]
fn housing_block() {
    // A box without a cylinder of the block's width.
    let block = |l: f64, w: f64, h: f64, d: f64, height: f64| {
        let axis = if height == 0.0 { h / 2.0 } else { height };
        let (body, hole) = (l * w * h, PI / 4.0 * d * d * w);
        let wanted = Wanted {
            volume: body - hole,
            centre: [0.0, 0.0, (body * h / 2.0 - hole * axis) / (body - hole)],
            min: [-l / 2.0, -w / 2.0, 0.0],
            max: [l / 2.0, w / 2.0, h],
        };
        let params =
            json!({"length": l, "width": w, "height": h, "bore_d": d, "bore_height": height});
        (params, wanted)
    };
    check(
        "base_frame.housing_block",
        vec![
            block(80.0, 40.0, 80.0, 47.0, 0.0),
            block(120.0, 80.0, 60.0, 25.0, 41.0),
        ],
    );
}

#[test]
fn stepped_shaft() {
    let shaft = |segments: &[(f64, f64)]| {
        let (mut volume, mut moment, mut z, mut largest) = (0.0, 0.0, 0.0, 0.0_f64);
        for (d, length) in segments {
            let v = PI / 4.0 * d * d * length;
            volume += v;
            moment += v * (z + length / 2.0);
            z += length;
            largest = largest.max(*d);
        }
        let r = largest / 2.0;
        let wanted = Wanted {
            volume,
            centre: [0.0, 0.0, moment / volume],
            min: [-r, -r, 0.0],
            max: [r, r, z],
        };
        let list: Vec<Value> = segments
            .iter()
            .map(|(d, l)| json!({"d": d, "length": l}))
            .collect();
        (json!({"segments": list}), wanted)
    };
    check(
        "base_frame.stepped_shaft",
        vec![
            shaft(&[(20.0, 60.0), (25.0, 10.0), (20.0, 40.0)]),
            shaft(&[(8.0, 100.0)]),
            shaft(&[(10.0, 5.0), (10.0, 5.0), (6.0, 12.5), (30.0, 1.0)]),
        ],
    );
}

#[test]
fn ball_bearing() {
    let bearing = |d_i: f64, d_o: f64, b: f64| {
        // A ring without a groove on each side: 0.3 of the section from either edge, 0.1 deep.
        let h = (d_o - d_i) / 2.0;
        let (inner, outer) = (d_i / 2.0 + 0.3 * h, d_o / 2.0 - 0.3 * h);
        let ring = PI / 4.0 * (d_o * d_o - d_i * d_i) * b;
        let groove = PI * (outer * outer - inner * inner) * 0.1 * h;
        let r = d_o / 2.0;
        let wanted = Wanted {
            volume: ring - 2.0 * groove,
            centre: [0.0, 0.0, b / 2.0],
            min: [-r, -r, 0.0],
            max: [r, r, b],
        };
        (json!({"d_i": d_i, "d_o": d_o, "width": b}), wanted)
    };
    check(
        "bearing.ball",
        vec![bearing(20.0, 47.0, 14.0), bearing(8.0, 22.0, 7.0)],
    );
}
