//! The engineering axioms in use: found, cited, checked, and traced to the report.

use serde_json::{Value, json};

use crate::drafts::draft;
use crate::kit::Kit;

const PLATE: &str = "base_frame.rect_plate";
const BLOCK: &str = "base_frame.housing_block";
const BEARING: &str = "bearing.ball";
const HUB: &str = "base_frame.coupling_hub";
const BOSS: &str = "base_frame.boss";
const GEAR: &str = "gear.spur";

type Part<'a> = (&'a str, &'a str, Value);
type Mate<'a> = (&'a str, &'a str, &'a str, Value);

/// Makes an assembly of parts (name, factory, parameters) and mates (type, base, incoming, options), and
/// verifies it.
fn verified(kit: &mut Kit, assembly: &str, parts: &[Part<'_>], mates: &[Mate<'_>]) -> Value {
    kit.new_assembly(assembly);
    for (part, factory, params) in parts {
        kit.part(assembly, part, factory, params.clone());
    }
    for (i, (mate_type, base, incoming, options)) in mates.iter().enumerate() {
        let mut call = options.clone();
        call["assembly"] = json!(assembly);
        call["id"] = json!(format!("m{i}"));
        call["mate_type"] = json!(mate_type);
        call["base"] = json!(base);
        call["incoming"] = json!(incoming);
        kit.mate(call);
    }
    full(kit, assembly)
}

fn full(kit: &mut Kit, assembly: &str) -> Value {
    kit.ok("verify", json!({"assembly": assembly, "detail": "full"}))
}

/// The ids of the axioms that are broken: those stated as MUST, or those stated as SHOULD.
fn with_status(report: &Value, status: &str) -> Vec<String> {
    let each = report["axioms"]["each"].as_array().unwrap();
    let ids = each.iter().filter(|a| a["status"] == status);
    ids.map(|a| a["axiom"].as_str().unwrap().to_owned())
        .collect()
}

/// A finding of an axiom's own, whole: code, statement, advice, the call to begin with.
fn own_finding<'a>(report: &'a Value, id: &str) -> &'a Value {
    let findings = report["findings"].as_array().unwrap();
    let own = |f: &&Value| f["check"] == "axioms" && f["axioms"][0]["axiom"] == id;
    let f = findings
        .iter()
        .find(own)
        .unwrap_or_else(|| panic!("{id}: {findings:?}"));
    assert_eq!(f["axioms"][0]["role"], "broken", "{f}");
    assert!(f["axioms"][0]["statement"].as_str().unwrap().len() > 20);
    let d = &f["diagnostic"];
    assert_eq!(d["code"], "axiom_broken");
    assert!(d["message"].as_str().unwrap().starts_with(id), "{d}");
    assert!(
        d["hint"].is_string() && d["next"]["tool"].is_string(),
        "{d}"
    );
    f
}

#[test]
fn axioms_are_found_by_what_a_mate_is() {
    let mut kit = Kit::new();
    let ids = |answer: &Value| -> Vec<String> {
        let all = answer["axioms"].as_array().unwrap();
        all.iter()
            .map(|a| a["axiom"].as_str().unwrap().to_owned())
            .collect()
    };
    let all = kit.ok("find_axioms", json!({"limit": 62}));
    assert_eq!((&all["total"], &all["more"]), (&json!(62), &json!(0)));
    assert!(ids(&all).is_sorted());
    // A page of ten, and the next one.
    let first = kit.ok("find_axioms", json!({}));
    assert_eq!((ids(&first).len(), &first["more"]), (10, &json!(52)));
    let next = kit.ok("find_axioms", json!({"offset": 10}));
    assert_eq!(ids(&next), ids(&all)[10..20]);

    let gears = kit.ok("find_axioms", json!({"mate_type": "gear_mesh"}));
    // The ten that name the mate come before those that are open to every mate.
    assert!(
        ids(&gears)
            .iter()
            .all(|id| id.starts_with('G') || id == "K-04"),
        "{gears}"
    );
    let bearings = kit.ok(
        "find_axioms",
        json!({"mate_type": "coaxial", "port_types": ["BORE"], "classes": ["bearing/ball"],
               "words": "ring"}),
    );
    assert!(ids(&bearings).contains(&"B-01".to_owned()), "{bearings}");
    let one = kit.ok("find_axioms", json!({"id": "g-05"}));
    let entry = &one["axioms"][0];
    assert_eq!(
        (&entry["axiom"], &entry["checked"]),
        (&json!("G-05"), &json!("contact_ratio"))
    );
    assert!(entry["source"].as_str().unwrap().contains("Shigley"));
    assert!(entry["reason"].is_string());
    // Why there is no check.
    let unchecked = kit.ok("find_axioms", json!({"id": "T-11"}));
    let why = unchecked["axioms"][0]["checked"].as_str().unwrap();
    assert!(why.starts_with("no: "), "{why}");

    let d = kit.refusal("find_axioms", json!({"id": "G-5"}));
    assert_eq!(d["code"], "axiom_unknown");
    assert_eq!(d["expected"].as_array().unwrap().len(), 62);
    let d = kit.refusal("find_axioms", json!({"mate_type": "glue"}));
    assert_eq!(d["code"], "argument_invalid");
}

#[test]
fn what_a_mate_cites_is_checked_when_it_is_made() {
    let mut kit = Kit::new();
    kit.new_assembly("a");
    kit.part("a", "plate", PLATE, json!({}));
    kit.part("a", "block", BLOCK, json!({}));
    let call = |axioms: Value| {
        json!({
            "assembly": "a", "id": "m", "mate_type": "face_to_face", "base": "plate:top_face",
            "incoming": "block:bottom_face", "axioms": axioms,
        })
    };
    let d = kit.refusal("mate", call(json!(["C-1"])));
    assert_eq!(
        (&d["code"], &d["found"]),
        (&json!("axiom_unknown"), &json!("C-1"))
    );
    let d = kit.refusal("mate", call(json!(["C-01", "G-02"])));
    assert_eq!(
        (&d["code"], &d["found"]),
        (&json!("axiom_inapplicable"), &json!("G-02"))
    );
    assert_eq!(d["expected"]["C-01"], "Face on face");
    assert!(d["expected"].as_object().unwrap().len() <= 12);
    assert_eq!(d["next"]["tool"], "find_axioms");
    // The call that it names is one.
    let found = kit.ok("find_axioms", d["next"]["arguments"].clone());
    let all = found["axioms"].as_array().unwrap();
    assert!(all.iter().any(|a| a["axiom"] == "C-01"), "{found}");

    let made = kit.mate(call(json!([])));
    let warning = &made["state"]["warnings"][0];
    assert_eq!(
        (&warning["code"], &warning["severity"]),
        (&json!("axiom_missing"), &json!("warning"))
    );
    kit.ok(
        "remove",
        json!({"assembly": "a", "kind": "mate", "name": "m"}),
    );
    let made = kit.mate(call(json!(["C-01", "F-03"])));
    assert!(made["state"].get("warnings").is_none(), "{made}");
}

#[test]
fn shafts_bearings_and_hubs_that_break_an_axiom() {
    let mut kit = Kit::new();
    // One bearing, about which the shaft tilts.
    kit.stand("tilting");
    let report = full(&mut kit, "tilting");
    assert_eq!(with_status(&report, "fail"), ["B-03", "P-01"]);
    assert_eq!(report["verdict"], "fail");
    // Its collar stands against the bearing's front, and nothing holds the bearing in its bore.
    assert_eq!(own_finding(&report, "B-03")["values"]["ways_held"], 0.0);
    let f = own_finding(&report, "P-01");
    assert_eq!(
        (&f["parts"], &f["mates"]),
        (&json!(["shaft"]), &json!(["m3"]))
    );
    // The mate between them cites it and another one.
    assert_eq!(f["axioms"][1]["axiom"], "C-02");
    assert_eq!(f["axioms"][1]["role"], "cited");

    // A bearing without a shaft.
    let in_bore = json!({"d_mm": -7, "direction": "same"});
    let report = verified(
        &mut kit,
        "empty",
        &[("block", BLOCK, json!({})), ("bearing", BEARING, json!({}))],
        &[("coaxial", "block:bore_port", "bearing:outer_ring", in_bore)],
    );
    assert_eq!(with_status(&report, "fail"), ["B-01"]);
    own_finding(&report, "B-01");

    // A hub of 10 mm that turns freely on its shaft of 20 mm; two bearings carry the shaft.
    kit.whole_stand("hub");
    kit.part("hub", "hub", HUB, json!({"length": 10}));
    kit.mate(json!({
        "assembly": "hub", "id": "m6", "mate_type": "coaxial", "d_mm": -26,
        "base": "shaft:shaft_seat_1", "incoming": "hub:shaft_seat", "axioms": ["P-02"],
    }));
    // The shaft turns, the hub turns and slides.
    kit.intent(
        "hub",
        json!({"intended_motions": [], "intended_mobility": 3}),
    );
    let report = full(&mut kit, "hub");
    assert_eq!(with_status(&report, "fail"), ["P-02"]);
    let f = own_finding(&report, "P-02");
    assert_eq!(f["diagnostic"]["next"]["tool"], "remove");
    // SHOULD warns, and is no fault of the assembly; nor is what is left open of it.
    assert_eq!(with_status(&report, "warning"), ["B-04", "P-03"]);
    let f = own_finding(&report, "P-03");
    assert_eq!(
        (&f["verdict"], &f["diagnostic"]["severity"]),
        (&json!("pass"), &json!("warning"))
    );
    assert_eq!(f["values"]["length_mm"], 10.0);
}

#[test]
fn gears_that_break_an_axiom() {
    let mut kit = Kit::new();
    // Two bosses on a plate, a gear on each, teeth of 0.05 mm less: distances and teeth by the case.
    let mut pair = |name: &str, half_mm: f64, one: Value, two: Value, mesh: Value| {
        let boss = json!({"diameter": 12, "height": 15, "bore_d": 4});
        let on = json!({"d_mm": 7.5, "direction": "same"});
        let parts = [
            ("plate", PLATE, json!({"length": 300})),
            ("left", BOSS, boss.clone()),
            ("right", BOSS, boss),
            ("one", GEAR, one),
            ("two", GEAR, two),
        ];
        let draft_mates = |id: &str,
                           mate_type: &str,
                           base: [&str; 2],
                           other: [&str; 2],
                           options: Value,
                           axiom: &str| {
            json!({
                "id": id, "mate_type": mate_type, "axioms": [axiom], "options": options,
                "base": {"ref": base[0], "port": base[1]},
                "incoming": {"ref": other[0], "port": other[1]},
            })
        };
        let face = |u: f64| json!({"u_mm": u, "bond": "glued"});
        let mates = [
            draft_mates(
                "l",
                "face_to_face",
                ["plate", "top_face"],
                ["left", "base_face"],
                face(-half_mm),
                "C-01",
            ),
            draft_mates(
                "r",
                "face_to_face",
                ["plate", "top_face"],
                ["right", "base_face"],
                face(half_mm),
                "C-01",
            ),
            draft_mates(
                "o",
                "coaxial",
                ["left", "outer"],
                ["one", "bore"],
                on.clone(),
                "C-02",
            ),
            draft_mates(
                "t",
                "coaxial",
                ["right", "outer"],
                ["two", "bore"],
                on,
                "C-02",
            ),
            draft_mates(
                "mesh",
                "gear_mesh",
                ["one", "mesh_point"],
                ["two", "mesh_point"],
                mesh,
                "G-02",
            ),
        ];
        let parts: Vec<Value> = parts
            .into_iter()
            .map(|(id, factory, params)| json!({"id": id, "factory": factory, "params": params}))
            .collect();
        let text = json!({"assembly": {"id": name, "intended_mobility": 3, "parts": parts, "mates": mates}}).to_string();
        let answer = kit.ok("realize", json!({"draft": text, "keep_failed": true}));
        assert_eq!(answer["realized"], true, "{answer}");
        full(&mut kit, name)
    };
    let gear = |teeth: u32, more: Value| {
        let mut params =
            json!({"module": 2, "teeth": teeth, "width": 15, "bore_d": 12, "backlash_mm": 0.05});
        for (k, v) in more.as_object().unwrap() {
            params[k] = v.clone();
        }
        params
    };
    let plain = || gear(21, json!({}));
    // 21 and 21 teeth of module 2 stand 42 mm apart, a tooth of the one in a gap of the other.
    let report = pair("sound", 21.0, plain(), plain(), json!({}));
    let none: [&str; 0] = [];
    assert_eq!(with_status(&report, "fail"), none, "{report}");
    assert_eq!(report["verdict"], "pass", "{report}");

    // Half a millimetre too far: the mate does not hold, and the axiom says what that means.
    let report = pair("far", 21.25, plain(), plain(), json!({}));
    let broken = with_status(&report, "fail");
    assert!(broken.contains(&"G-01".to_owned()), "{broken:?}");
    let f = own_finding(&report, "G-01");
    assert!(
        crate::kit::near(&f["values"]["distance_mm"], 42.5, 1e-6),
        "{f}"
    );
    assert!(
        crate::kit::near(&f["values"]["operating_distance_mm"], 42.0, 1e-6),
        "{f}"
    );
    assert_eq!(
        f["axioms"][1],
        json!({
            "axiom": "G-02", "role": "cited", "statement": f["axioms"][1]["statement"],
        })
    );

    // Teeth that are 0.4 mm thinner on both gears leave 0.8 mm of play, and 0.3 modules are the most.
    let thin = || gear(21, json!({"backlash_mm": 0.4}));
    let report = pair("loose", 21.0, thin(), thin(), json!({}));
    assert_eq!(with_status(&report, "fail"), ["G-08"], "{report}");
    let f = own_finding(&report, "G-08");
    assert!(
        crate::kit::near(&f["values"]["backlash_mm"], 0.8, 1e-4),
        "{f}"
    );

    // Nine teeth at 30 degrees: 2 sqrt(5.5^2 - 3.897^2) - 4.5 = 3.262 modules of path over pitches of
    // pi cos 30 = 2.721 are 1.199 pairs of teeth, and 1.2 is the least.
    let steep = || {
        gear(
            9,
            json!({"pressure_angle_deg": 30, "bore_d": 12, "module": 3}),
        )
    };
    let report = pair("few", 13.5, steep(), steep(), json!({}));
    assert_eq!(with_status(&report, "fail"), ["G-05"], "{report}");
    let f = own_finding(&report, "G-05");
    assert!(
        crate::kit::near(&f["values"]["contact_ratio"], 1.199, 1e-3),
        "{f}"
    );

    // Drawn without any play: that tolerances give it cannot be told.
    let exact = || gear(21, json!({"backlash_mm": 0}));
    let report = pair("exact", 21.0, exact(), exact(), json!({}));
    assert_eq!(with_status(&report, "indeterminate"), ["G-08"]);
    assert_eq!(report["verdict"], "indeterminate");
}

/// Two plates and so many bolts of a length with nuts; without washers where the bolts are too short.
fn bolted(kit: &mut Kit, name: &str, bolts: usize, length: f64, engaged: bool) -> Value {
    let plate = json!({"length": 120, "width": 80, "thickness": 12, "bolt_d": 8, "edge": 15});
    let mut parts = vec![
        ("lower".to_owned(), PLATE, plate.clone()),
        ("upper".to_owned(), PLATE, plate),
    ];
    let mut mates = vec![(
        "face_to_face",
        "lower:top_face".to_owned(),
        "upper:bottom_face".to_owned(),
        json!({"axioms": ["C-01", "N-07"]}),
    )];
    let below = length - 24.0;
    for i in 1..=bolts {
        let (bolt, nut) = (format!("bolt_{i}"), format!("nut_{i}"));
        parts.push((
            bolt.clone(),
            "fastener.bolt",
            json!({"d": 8, "length": length}),
        ));
        parts.push((nut.clone(), "fastener.nut", json!({"d": 8})));
        mates.push((
            "coaxial_face",
            format!("upper:corner_hole_{i}"),
            format!("{bolt}:head_seat"),
            json!({"axioms": ["T-10"]}),
        ));
        mates.push((
            "coaxial_face",
            format!("lower:corner_hole_back_{i}"),
            format!("{nut}:face"),
            json!({"axioms": ["T-10"]}),
        ));
        if engaged {
            let through = (below - 6.8_f64).max(0.0);
            mates.push((
                "thread_engage",
                format!("{bolt}:thread"),
                format!("{nut}:thread_internal"),
                json!({"d_t_mm": below.min(6.8), "through_mm": through, "axioms": ["T-01", "T-05"]}),
            ));
        }
    }
    let parts: Vec<Part<'_>> = parts
        .iter()
        .map(|(n, f, p)| (n.as_str(), *f, p.clone()))
        .collect();
    let mates: Vec<Mate<'_>> = mates
        .iter()
        .map(|(t, b, i, o)| (*t, b.as_str(), i.as_str(), o.clone()))
        .collect();
    verified(kit, name, &parts, &mates)
}

#[test]
fn fasteners_and_seats_that_break_an_axiom() {
    let mut kit = Kit::new();
    let none: [&str; 0] = [];
    let report = bolted(&mut kit, "sound", 2, 35.0, true);
    assert_eq!(with_status(&report, "fail"), none, "{report}");
    assert_eq!(report["verdict"], "pass", "{report}");

    // 6.9 mm below the plates and a nut of 6.8: 0.1 mm stand out, and one pitch (1.25 mm) is the least.
    let report = bolted(&mut kit, "short", 2, 30.9, true);
    assert_eq!(with_status(&report, "fail"), ["T-05"]);
    let f = own_finding(&report, "T-05");
    assert!(
        crate::kit::near(&f["values"]["protrusion_mm"], 0.1, 1e-6),
        "{f}"
    );
    assert_eq!(f["diagnostic"]["next"]["tool"], "describe_factory");

    // One bolt is a pivot.
    let report = bolted(&mut kit, "pivot", 1, 35.0, true);
    assert_eq!(with_status(&report, "fail"), ["T-09"]);
    own_finding(&report, "T-09");

    // Threads that nobody has engaged: the bolt clamps nothing, and what overlaps is not meant.
    let report = bolted(&mut kit, "unclamped", 2, 35.0, false);
    assert_eq!(with_status(&report, "fail"), ["F-04", "T-01"]);
    own_finding(&report, "T-01");

    // Holes 9 mm from the edge: 1.2 diameters of 9 mm are the least.
    let report = verified(
        &mut kit,
        "edge",
        &[("plate", PLATE, json!({"bolt_d": 8, "edge": 9}))],
        &[],
    );
    assert_eq!(with_status(&report, "fail"), ["N-03"]);
    assert_eq!(own_finding(&report, "N-03")["values"]["least_mm"], 10.8);

    // A block set on the corner of a plate hangs over its edges.
    let report = verified(
        &mut kit,
        "over",
        &[("plate", PLATE, json!({})), ("block", BLOCK, json!({}))],
        &[(
            "snap_to_face",
            "plate:top_face",
            "block:bottom_face",
            json!({"u": 0.1, "v": 0.5, "axioms": ["C-04"]}),
        )],
    );
    assert_eq!(with_status(&report, "fail"), ["C-04"]);
    // 20 mm from the end of the plate, and the block is 80 mm long.
    let f = own_finding(&report, "C-04");
    assert_eq!(f["values"]["over_the_edge_mm"], 20.0);
    assert_eq!(f["parts"], json!(["plate", "block"]));
}

/// What an axiom came to.
fn status<'a>(report: &'a Value, id: &str) -> &'a str {
    let each = report["axioms"]["each"].as_array().unwrap();
    let fact = each.iter().find(|a| a["axiom"] == id).unwrap();
    fact["status"].as_str().unwrap()
}

#[test]
fn walls_that_are_too_thin_for_their_bores() {
    let mut kit = Kit::new();
    let on = || json!({"axioms": ["C-01"]});
    let mut block = |name: &str, height: f64| {
        let block = json!({"bore_d": 47, "height": 80, "bore_height": height});
        verified(
            &mut kit,
            name,
            &[("plate", PLATE, json!({})), ("block", BLOCK, block)],
            &[("face_to_face", "plate:top_face", "block:bottom_face", on())],
        )
    };
    // A tenth of 47 mm are 4.7; the axis 52 mm up leaves 80 - 52 - 23.5 = 4.5 above the bore, 50 mm up 6.5.
    let report = block("thin", 52.0);
    assert_eq!(status(&report, "N-02"), "warning");
    let f = own_finding(&report, "N-02");
    assert!(crate::kit::near(&f["values"]["wall_mm"], 4.5, 0.02), "{f}");
    assert_eq!(f["values"]["least_mm"], 4.7);
    assert_eq!(status(&block("thick", 50.0), "N-02"), "pass");

    // Keyway and set screw open the bore of a hub; beside them there are 10 and 3 mm of wall, and 2 are
    // the least.
    let mut hub = |name: &str, diameter: f64, keyway: bool| {
        let hub = json!({"diameter": diameter, "bore_d": 20, "keyway": keyway, "set_screw_d": 6});
        verified(&mut kit, name, &[("hub", HUB, hub)], &[])
    };
    assert_eq!(status(&hub("keyed", 40.0, true), "N-02"), "pass");
    assert_eq!(status(&hub("screwed", 26.0, false), "N-02"), "pass");
    // Rings and washers are thin on purpose.
    let rings = [
        ("ring", BEARING, json!({"d_i": 46})),
        ("washer", "fastener.washer", json!({"d": 8, "d_o": 10.1})),
    ];
    for ring in rings {
        let report = verified(&mut kit, ring.0, std::slice::from_ref(&ring), &[]);
        assert_eq!(status(&report, "N-02"), "not_applicable");
    }
}

#[test]
fn what_is_enclosed_was_never_brought_in() {
    let mut kit = Kit::new();
    let mut case = |name: &str, open: bool| {
        verified(
            &mut kit,
            name,
            &[
                ("case", "test.case", json!({"open": open})),
                ("block", "test.block", json!({})),
            ],
            &[(
                "face_to_face",
                "case:floor",
                "block:bottom",
                json!({"axioms": ["C-01"]}),
            )],
        )
    };
    let report = case("closed", false);
    assert_eq!(with_status(&report, "fail"), ["S-01"]);
    let f = own_finding(&report, "S-01");
    assert_eq!(f["parts"], json!(["case", "block"]));
    // Three axes of the world and ten diagonals, both ways.
    assert_eq!(f["values"]["directions"], 26.0);
    assert_eq!(status(&case("open", true), "S-01"), "pass");

    // Collars outside of both bearings: each ring would have to pass a collar that is wider than its hole.
    kit.whole_stand("locked");
    for (kind, name) in [("mate", "m3"), ("mate", "m5"), ("part", "shaft")] {
        kit.ok(
            "remove",
            json!({"assembly": "locked", "kind": kind, "name": name}),
        );
    }
    let collars = [(25, 10), (20, 40), (25, 10)].map(|(d, l)| json!({"d": d, "length": l}));
    let collars = json!({"segments": collars});
    kit.part("locked", "shaft", "base_frame.stepped_shaft", collars);
    for (id, bearing, direction) in [("m3", "bearing", "same"), ("m5", "back", "opposed")] {
        kit.mate(json!({
            "assembly": "locked", "id": id, "mate_type": "coaxial", "d_mm": -20, "direction": direction,
            "base": format!("{bearing}:inner_ring"), "incoming": "shaft:shaft_seat_2",
            "axioms": ["C-02", "P-01"],
        }));
    }
    let report = full(&mut kit, "locked");
    // No straight way is free; that none with a tilt is cannot be shown.
    assert_eq!(with_status(&report, "indeterminate"), ["S-01"]);
}

#[test]
fn a_head_under_another_plate() {
    let mut kit = Kit::new();
    let report = bolted(&mut kit, "free", 2, 35.0, true);
    assert_eq!(status(&report, "S-02"), "pass");
    // A plate 20 mm above the upper one: a head of M8 is 5.3 mm high, and 3 x 13 mm are wanted above it.
    kit.part(
        "free",
        "cover",
        PLATE,
        json!({"length": 120, "width": 80, "thickness": 12}),
    );
    kit.mate(json!({
        "assembly": "free", "id": "over", "mate_type": "face_to_face", "d_n_mm": 20,
        "base": "upper:top_face", "incoming": "cover:bottom_face", "axioms": ["C-01"],
    }));
    let report = full(&mut kit, "free");
    assert_eq!(with_status(&report, "fail"), ["S-02"]);
    let f = own_finding(&report, "S-02");
    assert_eq!(f["parts"], json!(["bolt_1", "cover"]));
    assert!(crate::kit::near(&f["values"]["free_mm"], 14.7, 1e-6), "{f}");
    assert_eq!(f["values"]["tool_length_mm"], 39.0);
}

#[test]
fn a_set_screw_on_a_flat_and_on_the_round() {
    let mut kit = Kit::new();
    let mut held = |name: &str, flat: f64| {
        let parts = [
            ("shaft", "test.flat_shaft", json!({"flat": flat})),
            ("hub", HUB, json!({"set_screw_d": 6})),
            ("screw", "test.grub", json!({})),
        ];
        // The hub's screw is 15 mm above its foot, the middle of the shaft's flat 40 mm.
        let on = json!({"d_mm": 15, "direction": "same", "axioms": ["C-02"]});
        // From the hub's outside at 20 mm to the shaft: 10 mm to its round, and the flat's depth.
        let depth = json!({"d_t_mm": 10.0 + flat, "axioms": ["T-08"]});
        let mates = [
            ("coaxial", "shaft:seat", "hub:shaft_seat", on),
            ("thread_engage", "hub:set_screw", "screw:thread", depth),
        ];
        verified(&mut kit, name, &parts, &mates)
    };
    assert_eq!(status(&held("flat", 0.3), "T-08"), "pass");
    let report = held("round", 0.0);
    assert_eq!(status(&report, "T-08"), "warning");
    let f = own_finding(&report, "T-08");
    assert_eq!(f["parts"], json!(["hub", "screw", "shaft"]));
}

#[test]
fn what_is_held_twice_wants_a_reason() {
    let mut kit = Kit::new();
    // Bolts and bearings are reasons, and the whole stand says which.
    assert_eq!(
        status(&bolted(&mut kit, "bolts", 2, 35.0, true), "C-05"),
        "pass"
    );
    kit.whole_stand("stand");
    let report = full(&mut kit, "stand");
    assert_eq!(status(&report, "C-05"), "pass");
    let each = report["axioms"]["each"].as_array().unwrap();
    let fact = each.iter().find(|a| a["axiom"] == "C-05").unwrap();
    let why = fact["assumptions"][0].as_str().unwrap();
    assert!(why.contains("'shaft' is carried at 2 places"), "{why}");

    // The block on the plate once more: no pattern wants it.
    kit.mate(json!({
        "assembly": "stand", "id": "again", "mate_type": "snap_to_face", "u": 0.5, "v": 0.5,
        "base": "plate:top_face", "incoming": "block:bottom_face", "axioms": ["C-04"],
    }));
    let report = full(&mut kit, "stand");
    assert_eq!(status(&report, "C-05"), "warning");
    let found = report["findings"].as_array().unwrap();
    let own: Vec<_> = found
        .iter()
        .filter(|f| f["axioms"][0]["axiom"] == "C-05")
        .collect();
    assert_eq!(own.len(), 1);
    assert_eq!(own[0]["mates"], json!(["again", "m1"]));
}

#[test]
fn from_the_specification_to_the_report() {
    let mut kit = Kit::new();
    // The block 5 mm deep in the plate.
    let text = draft("good_stand").replace(
        "incoming: {ref: block, port: bottom_face}\n      options: {bond: welded}",
        "incoming: {ref: block, port: bottom_face}\n      options: {d_n_mm: -5, bond: welded}",
    );
    kit.ok("realize", json!({"draft": text, "keep_failed": true}));
    let report = full(&mut kit, "good_stand");
    let stored = std::fs::read(kit.file("assemblies/good_stand/report.json")).unwrap();
    let stored: Value = serde_json::from_slice(&stored).unwrap();
    assert_eq!(stored["findings"], report["findings"]);
    assert_eq!(stored["axioms"], report["axioms"]);
    let found = report["findings"].as_array().unwrap();
    let clash = found
        .iter()
        .find(|f| f["diagnostic"]["code"] == "clash")
        .unwrap();
    let traced: Vec<(&str, &str)> = clash["axioms"]
        .as_array()
        .unwrap()
        .iter()
        .map(|a| (a["axiom"].as_str().unwrap(), a["role"].as_str().unwrap()))
        .collect();
    assert_eq!(traced, [("F-04", "broken"), ("C-01", "cited")]);
    // One finding tells of the clash, not two.
    assert!(
        found
            .iter()
            .all(|f| f["axioms"][0]["axiom"] != "F-04" || f["check"] == "interference")
    );

    let axioms = &report["axioms"];
    assert_eq!(axioms["total"], 62);
    let counted: u64 = [
        "passed",
        "failed",
        "warned",
        "indeterminate",
        "not_applicable",
        "not_checked",
    ]
    .iter()
    .map(|k| axioms[k].as_u64().unwrap())
    .sum();
    assert_eq!(counted, 62);
    let each = axioms["each"].as_array().unwrap();
    assert_eq!(each.len(), 62);
    let fact = |id: &str| each.iter().find(|a| a["axiom"] == id).unwrap();
    assert_eq!(
        (&fact("P-01")["status"], &fact("P-01")["cited_by"]),
        (&json!("pass"), &json!(["m_shaft", "m_shaft_back"]))
    );
    // What was not checked, and why.
    assert_eq!(fact("T-11")["status"], "not_checked");
    assert!(fact("T-11")["why"].is_string());
    let lines: Vec<&str> = report["not_checked"]
        .as_array()
        .unwrap()
        .iter()
        .map(|l| l.as_str().unwrap())
        .collect();
    for id in with_status(&report, "not_checked") {
        assert!(lines.iter().any(|l| l.contains(&id)), "{id}: {lines:?}");
    }
    // In short, the counts only.
    let short = kit.ok("verify", json!({"assembly": "good_stand"}));
    assert!(short["axioms"].get("each").is_none());
    assert_eq!(short["axioms"]["total"], 62);
}
