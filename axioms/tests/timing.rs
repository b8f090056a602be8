//! How long the checks take on many parts (`cargo test --release -p assemcad-axioms --test timing -- --ignored
//! --nocapture`).

use std::time::Instant;

use assemcad_axioms::{Facts, Indexed, checks};
use assemcad_model::angle::sin_cos_deg;
use serde_json::{Value, json};

/// Two flanges with a ring of bolts, each with two washers and a nut.
fn flange(bolts: usize) -> Value {
    let r = 10.0 * bolts as f64;
    let at = |i: usize, z: f64| {
        let (sin, cos) = sin_cos_deg(360.0 * i as f64 / bolts as f64);
        [r * cos, r * sin, z]
    };
    let frame = |o: [f64; 3], up: f64| json!({"origin": o, "x": [1, 0, 0], "z": [0, 0, up]});
    let port = |name: String, t: &str, o: [f64; 3], up: f64, params: Value| json!({"name": name, "type": t, "frame": frame(o, up), "params": params});
    let placed = |[x, y, z]: [f64; 3]| json!([[1, 0, 0, x], [0, 1, 0, y], [0, 0, 1, z]]);
    let extent = json!({"extent_x": 3.0 * r, "extent_y": 3.0 * r});
    let hole = json!({"diameter": 9, "bolt_diameter": 8, "depth": 12});
    let mut parts = Vec::new();
    for (n, id) in ["lower", "upper"].into_iter().enumerate() {
        let mut ports = vec![
            port(
                "top".into(),
                "FLAT_FACE",
                [0.0, 0.0, 12.0],
                1.0,
                extent.clone(),
            ),
            port("bottom".into(), "FLAT_FACE", [0.0; 3], -1.0, extent.clone()),
        ];
        for i in 0..bolts {
            ports.push(port(
                format!("hole_{i}"),
                "CLEARANCE_HOLE",
                at(i, 12.0),
                1.0,
                hole.clone(),
            ));
            ports.push(port(
                format!("back_{i}"),
                "CLEARANCE_HOLE",
                at(i, 0.0),
                -1.0,
                hole.clone(),
            ));
        }
        let here = placed([0.0, 0.0, 12.0 * n as f64]);
        parts.push(json!({"id": id, "factory": "base_frame.bolt_circle_flange", "ports": ports, "placement": here}));
    }
    let mut mates = vec![json!({
        "id": "stack", "mate_type": "face_to_face", "base": {"ref": "lower", "port": "top"},
        "incoming": {"ref": "upper", "port": "bottom"},
    })];
    let seat = json!({"inner_diameter": 8, "outer_diameter": 13});
    let thread = |length: &str| {
        json!({
            "diameter": 8, "pitch": 1.25, "hand": 1, length: 6.8, "modelled_diameter": 7,
        })
    };
    let mut overlaps = vec![json!({"a": "lower", "b": "upper", "common_mm3": 0.0})];
    let mut stops = vec![json!({"part": "lower", "by": "upper", "play_mm": 0})];
    for i in 0..bolts {
        let id = |what: &str| format!("{what}_{i}");
        let mut part = |what: &str, kind: &str, z: f64, ports: Vec<Value>| {
            let factory = format!("fastener.{kind}");
            parts.push(json!({"id": id(what), "factory": factory, "ports": ports, "placement": placed(at(i, z))}));
        };
        let ring = || {
            vec![
                port("seat".into(), "BOLT_SEAT", [0.0; 3], -1.0, seat.clone()),
                port(
                    "hole".into(),
                    "CLEARANCE_HOLE",
                    [0.0, 0.0, 1.6],
                    1.0,
                    hole.clone(),
                ),
            ]
        };
        part("washer", "washer", 24.0, ring());
        part("under", "washer", -1.6, ring());
        part(
            "bolt",
            "bolt",
            25.6,
            vec![
                port(
                    "head_seat".into(),
                    "BOLT_SEAT",
                    [0.0; 3],
                    -1.0,
                    seat.clone(),
                ),
                port(
                    "thread".into(),
                    "THREAD_EXTERNAL",
                    [0.0, 0.0, -36.0],
                    -1.0,
                    thread("length"),
                ),
            ],
        );
        part(
            "nut",
            "nut",
            -8.4,
            vec![
                port(
                    "face".into(),
                    "BOLT_SEAT",
                    [0.0, 0.0, 6.8],
                    1.0,
                    seat.clone(),
                ),
                port(
                    "thread_internal".into(),
                    "THREAD_INTERNAL",
                    [0.0, 0.0, 6.8],
                    1.0,
                    thread("depth"),
                ),
            ],
        );
        let mut mate =
            |name: &str, kind: &str, [a, p]: [String; 2], [b, q]: [String; 2], options: Value| {
                mates.push(json!({
                "id": format!("{name}_{i}"), "mate_type": kind, "base": {"ref": a, "port": p},
                "incoming": {"ref": b, "port": q}, "options": options, "axioms": ["T-01", "T-10"],
            }));
            };
        let named = |a: String, b: &str| [a, b.to_owned()];
        mate(
            "w",
            "coaxial_face",
            named("upper".into(), &id("hole")),
            named(id("washer"), "seat"),
            json!({}),
        );
        mate(
            "b",
            "coaxial_face",
            named(id("washer"), "hole"),
            named(id("bolt"), "head_seat"),
            json!({}),
        );
        mate(
            "u",
            "coaxial_face",
            named("lower".into(), &id("back")),
            named(id("under"), "seat"),
            json!({}),
        );
        mate(
            "n",
            "coaxial_face",
            named(id("under"), "hole"),
            named(id("nut"), "face"),
            json!({}),
        );
        let depth = json!({"d_t_mm": 6.8, "through_mm": 2.0});
        mate(
            "t",
            "thread_engage",
            named(id("bolt"), "thread"),
            named(id("nut"), "thread_internal"),
            depth,
        );
        let chain = ["nut", "under"]
            .map(id)
            .into_iter()
            .chain(["lower".into(), "upper".into()]);
        let chain: Vec<String> = chain.chain(["washer", "bolt"].map(id)).collect();
        for (a, b) in chain.iter().zip(chain.iter().skip(1)) {
            overlaps.push(json!({"a": a, "b": b, "common_mm3": 0.0}));
            stops.push(json!({"part": a, "by": b, "play_mm": 0}));
        }
    }
    let redundant: Vec<Value> = mates
        .iter()
        .map(|m| json!({"mate": m["id"], "count": 6}))
        .collect();
    let contacts: Vec<Value> = mates
        .iter()
        .map(|m| json!({"mate": m["id"], "touches": true}))
        .collect();
    json!({
        "root": "lower", "parts": parts, "mates": mates, "intended_mobility": 0,
        "mobility": {"freedom": 0, "redundant": redundant, "unexplained": []},
        "measured": {
            "overlaps": overlaps, "contacts": contacts,
            "ways": {"axes": [{"axis": [0, 0, 1], "stops": stops}], "rays_a_side": 40},
        },
    })
}

#[test]
#[ignore = "a measurement"]
fn timings() {
    for bolts in [25, 50, 100, 250, 1000] {
        let facts: Facts = serde_json::from_value(flange(bolts)).unwrap();
        let parts = facts.parts.len();
        let start = Instant::now();
        let facts = Indexed::new(facts);
        let told = checks::run_all_on(&facts);
        println!(
            "{parts} parts: {} verdicts, {:?}",
            told.len(),
            start.elapsed()
        );
        let mut slow: Vec<_> = checks::ALL
            .iter()
            .map(|c| {
                let start = Instant::now();
                let n = c.run(&facts).len();
                (start.elapsed(), c.id(), n)
            })
            .collect();
        slow.sort();
        for (took, id, n) in slow.iter().rev().take(4) {
            println!("  {id}: {n}, {took:?}");
        }
    }
}
