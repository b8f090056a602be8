//! Every built-in factory: defaults, the corners of its ranges, and its ports as documented.
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    clippy::indexing_slicing,
    reason = "helpers of tests, outside of #[test] functions"
)]

use assemcad_factories::Registry;
use assemcad_model::diagnostic::{Code, Diagnostic};
use assemcad_model::param::{ParamKind, ParamSpec};
use assemcad_model::ports::{Port, PortType};
use assemcad_model::recipe::Op;
use serde_json::{Map, Value, json};

fn build(name: &str, params: Value) -> Result<(Vec<Op>, Vec<Port>), Vec<Diagnostic>> {
    let built = Registry::builtin().build(name, params.as_object().unwrap())?;
    assert_eq!(built.recipe.ops.len(), built.lines.len());
    assert!(built.lines.iter().all(|l| *l > 0), "{:?}", built.lines);
    Ok((built.recipe.ops.clone(), built.recipe.ports.clone()))
}

fn port<'a>(ports: &'a [Port], name: &str) -> &'a Port {
    ports
        .iter()
        .find(|p| p.name == name)
        .unwrap_or_else(|| panic!("no port {name}"))
}

#[track_caller]
fn is(
    ports: &[Port],
    name: &str,
    port_type: PortType,
    origin: [f64; 3],
    z: [f64; 3],
    x: [f64; 3],
    params: &[(&str, f64)],
) {
    let p = port(ports, name);
    assert_eq!(p.port_type, port_type, "{name}");
    for (a, b) in p.frame.origin.iter().zip(origin) {
        assert!((a - b).abs() < 1e-12, "{name} origin {:?}", p.frame.origin);
    }
    assert_eq!((p.frame.z, p.frame.x), (z, x), "{name}");
    assert_eq!(p.params.len(), params.len(), "{name}");
    for (key, value) in params {
        assert!(
            (p.params[*key] - value).abs() < 1e-12,
            "{name} {key} {}",
            p.params[*key]
        );
    }
}

const X: [f64; 3] = [1.0, 0.0, 0.0];
const Y: [f64; 3] = [0.0, 1.0, 0.0];
const Z: [f64; 3] = [0.0, 0.0, 1.0];
const NX: [f64; 3] = [-1.0, 0.0, 0.0];
const NY: [f64; 3] = [0.0, -1.0, 0.0];
const NZ: [f64; 3] = [0.0, 0.0, -1.0];

fn face(x: f64, y: f64) -> [(&'static str, f64); 2] {
    [("extent_x", x), ("extent_y", y)]
}

#[test]
fn the_ports_of_the_plate() {
    let (ops, ports) = build(
        "base_frame.rect_plate",
        json!({"length": 100, "width": 60, "thickness": 10}),
    )
    .unwrap();
    assert_eq!(ops.len(), 1);
    assert_eq!(ports.len(), 6);
    let flat = PortType::FlatFace;
    is(
        &ports,
        "top_face",
        flat,
        [0.0, 0.0, 10.0],
        Z,
        X,
        &face(100.0, 60.0),
    );
    is(
        &ports,
        "bottom_face",
        flat,
        [0.0; 3],
        NZ,
        X,
        &face(100.0, 60.0),
    );
    is(
        &ports,
        "side_face_x_pos",
        flat,
        [50.0, 0.0, 5.0],
        X,
        Y,
        &face(60.0, 10.0),
    );
    is(
        &ports,
        "side_face_x_neg",
        flat,
        [-50.0, 0.0, 5.0],
        NX,
        Y,
        &face(60.0, 10.0),
    );
    is(
        &ports,
        "side_face_y_pos",
        flat,
        [0.0, 30.0, 5.0],
        Y,
        X,
        &face(100.0, 10.0),
    );
    is(
        &ports,
        "side_face_y_neg",
        flat,
        [0.0, -30.0, 5.0],
        NY,
        X,
        &face(100.0, 10.0),
    );
}

#[test]
fn the_ports_of_the_housing() {
    let (ops, ports) = build("base_frame.housing_block", json!({"bore_height": 45})).unwrap();
    assert_eq!(
        ops.iter().map(Op::name).collect::<Vec<_>>(),
        ["box", "cylinder", "cut"]
    );
    assert_eq!(ports.len(), 8);
    let Op::Cylinder { at, radius, height } = &ops[1] else {
        panic!()
    };
    assert_eq!(
        (at.origin, at.z, *radius, *height),
        ([0.0, -20.0, 45.0], Y, 23.5, 40.0)
    );
    let bore = [("diameter", 47.0), ("depth", 40.0)];
    is(
        &ports,
        "bore_port",
        PortType::Bore,
        [0.0, 20.0, 45.0],
        Y,
        X,
        &bore,
    );
    is(
        &ports,
        "bore_port_back",
        PortType::Bore,
        [0.0, -20.0, 45.0],
        NY,
        X,
        &bore,
    );
    let flat = PortType::FlatFace;
    is(
        &ports,
        "side_face_y_pos",
        flat,
        [0.0, 20.0, 10.75],
        Y,
        X,
        &face(80.0, 21.5),
    );
    is(
        &ports,
        "side_face_y_neg",
        flat,
        [0.0, -20.0, 10.75],
        NY,
        X,
        &face(80.0, 21.5),
    );
    is(
        &ports,
        "side_face_x_pos",
        flat,
        [40.0, 0.0, 40.0],
        X,
        Y,
        &face(40.0, 80.0),
    );
    is(
        &ports,
        "side_face_x_neg",
        flat,
        [-40.0, 0.0, 40.0],
        NX,
        Y,
        &face(40.0, 80.0),
    );
    is(
        &ports,
        "top_face",
        flat,
        [0.0, 0.0, 80.0],
        Z,
        X,
        &face(80.0, 40.0),
    );
    is(
        &ports,
        "bottom_face",
        flat,
        [0.0; 3],
        NZ,
        X,
        &face(80.0, 40.0),
    );
    let (_, ports) = build("base_frame.housing_block", json!({})).unwrap();
    assert_eq!(port(&ports, "bore_port").frame.origin, [0.0, 20.0, 40.0]);
}

#[test]
fn every_thin_wall_is_reported() {
    let faults = build(
        "base_frame.housing_block",
        json!({"length": 48, "bore_d": 47, "bore_height": 24}),
    )
    .unwrap_err();
    assert_eq!(faults.len(), 2, "{faults:?}");
    for f in &faults {
        assert_eq!((f.code, f.place.as_str()), (Code::ParamInvalid, "params"));
        assert!(f.message.contains("bore_d"), "{f}");
    }
    assert!(faults[0].message.contains("length") && faults[1].message.contains("bore_height"));
}

#[test]
fn the_ports_of_the_shaft() {
    let (ops, ports) = build("base_frame.stepped_shaft", json!({})).unwrap();
    assert_eq!(ops.len(), 1);
    assert_eq!(ports.len(), 5);
    let seat = |d: f64, length: f64| [("diameter", d), ("length", length)];
    let shaft = PortType::Shaft;
    is(
        &ports,
        "shaft_seat_1",
        shaft,
        [0.0, 0.0, 30.0],
        Z,
        X,
        &seat(20.0, 60.0),
    );
    is(
        &ports,
        "shaft_seat_2",
        shaft,
        [0.0, 0.0, 65.0],
        Z,
        X,
        &seat(25.0, 10.0),
    );
    is(
        &ports,
        "shaft_seat_3",
        shaft,
        [0.0, 0.0, 90.0],
        Z,
        X,
        &seat(20.0, 40.0),
    );
    let flat = PortType::FlatFace;
    is(
        &ports,
        "end_face_start",
        flat,
        [0.0; 3],
        NZ,
        X,
        &face(20.0, 20.0),
    );
    is(
        &ports,
        "end_face_end",
        flat,
        [0.0, 0.0, 110.0],
        Z,
        X,
        &face(20.0, 20.0),
    );
}

#[test]
fn equal_neighbours_make_one_cylinder_and_near_ones_are_refused() {
    let points = |segments: Value| {
        let (ops, ports) =
            build("base_frame.stepped_shaft", json!({"segments": segments})).unwrap();
        (
            serde_json::to_value(&ops).unwrap()[0]["revolve"]["profile"]["outer"]["path"].clone(),
            ports.len(),
        )
    };
    let (one, ports) = points(json!([{"d": 10, "length": 5}, {"d": 10, "length": 7}]));
    assert_eq!(ports, 4);
    assert_eq!(one, points(json!([{"d": 10, "length": 12}])).0);
    assert_eq!(one["segments"].as_array().unwrap().len(), 3);
    let faults = build(
        "base_frame.stepped_shaft",
        json!({"segments": [{"d": 10, "length": 5}, {"d": 10.001, "length": 7}]}),
    )
    .unwrap_err();
    assert!(faults[0].message.contains("segments[1].d"), "{faults:?}");
}

#[test]
fn the_ports_of_the_bearing() {
    let (ops, ports) = build("bearing.ball", json!({})).unwrap();
    assert_eq!(ops.len(), 1);
    assert_eq!(ports.len(), 5);
    let bore = [("diameter", 20.0), ("depth", 14.0)];
    is(
        &ports,
        "inner_ring",
        PortType::Bore,
        [0.0, 0.0, 14.0],
        Z,
        X,
        &bore,
    );
    is(
        &ports,
        "inner_ring_back",
        PortType::Bore,
        [0.0; 3],
        NZ,
        X,
        &bore,
    );
    let press = [("diameter", 47.0), ("length", 14.0)];
    is(
        &ports,
        "outer_ring",
        PortType::PressFit,
        [0.0, 0.0, 7.0],
        Z,
        X,
        &press,
    );
    // h = 13.5: origin at 23.5 - 0.15 * 13.5, extents 0.3 * 13.5.
    let flat = PortType::FlatFace;
    is(
        &ports,
        "face_front",
        flat,
        [21.475, 0.0, 14.0],
        Z,
        X,
        &face(4.05, 4.05),
    );
    is(
        &ports,
        "face_back",
        flat,
        [21.475, 0.0, 0.0],
        NZ,
        X,
        &face(4.05, 4.05),
    );
    let faults = build("bearing.ball", json!({"d_i": 47})).unwrap_err();
    assert!(
        faults[0].message.contains("d_o") && faults[0].message.contains("d_i"),
        "{faults:?}"
    );
}

/// Smallest, default and largest value of a parameter.
fn corners(spec: &ParamSpec) -> Vec<Value> {
    match &spec.kind {
        ParamKind::Number { min, max, .. } => vec![json!(min), spec.default_value(), json!(max)],
        ParamKind::Integer { min, max, .. } => vec![json!(min), spec.default_value(), json!(max)],
        ParamKind::Choice { choices, .. } => choices.iter().map(|c| json!(c)).collect(),
        ParamKind::Flag { .. } => vec![json!(false), json!(true)],
        ParamKind::Records {
            fields,
            min_items,
            max_items,
            ..
        } => {
            let mut lists = vec![spec.default_value()];
            for record in combinations(fields) {
                for n in [*min_items, *max_items] {
                    lists.push(Value::Array(vec![Value::Object(record.clone()); n]));
                }
            }
            lists
        }
    }
}

fn combinations(specs: &[ParamSpec]) -> Vec<Map<String, Value>> {
    specs.iter().fold(vec![Map::new()], |all, spec| {
        let values = corners(spec);
        all.iter()
            .flat_map(|given| {
                values.iter().map(|value| {
                    let mut given = given.clone();
                    given.insert(spec.name.clone(), value.clone());
                    given
                })
            })
            .collect()
    })
}

#[test]
fn every_corner_is_built_or_refused_with_a_reason() {
    for name in Registry::builtin().names() {
        let factory = Registry::builtin().get(name).unwrap();
        let (mut built, mut refused) = (0, 0);
        // Of many parameters not every combination, but every value of each with most of the others:
        // the step has no factor in common with the three values.
        let all = combinations(factory.params());
        let step = if all.len() > 1000 { 7 } else { 1 };
        for params in all.into_iter().step_by(step) {
            match factory.build(&params) {
                Ok(result) => {
                    built += 1;
                    assert!(!result.recipe.ports.is_empty());
                    assert!(result.recipe.ports.iter().all(|p| p.faults().is_empty()));
                    result.recipe.hash().unwrap();
                }
                Err(faults) => {
                    refused += 1;
                    for f in faults {
                        assert_eq!(
                            (f.code, f.place.as_str()),
                            (Code::ParamInvalid, "params"),
                            "{f}"
                        );
                        let named = factory.params().iter().any(|s| f.message.contains(&s.name));
                        assert!(named, "{name} {params:?}: {f}");
                    }
                }
            }
        }
        assert!(
            built > refused / 8,
            "{name}: {built} built, {refused} refused"
        );
    }
}
