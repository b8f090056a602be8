//! Every function and method of the table, called with what it demands: the recorded call is compared
//! with one that is written from the table in another way.
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    clippy::indexing_slicing,
    reason = "helpers of tests, outside of #[test] functions"
)]

use assemcad_model::language::{Default, Kind, Param, Type, method, methods};
use assemcad_script::script;
use serde_json::{Value, json};

/// An argument of a kind as a script writes it, and as a recipe does. Call 0 is the chain `w`, call 1
/// the shape `s`.
fn sample(kind: Kind, name: &str) -> (String, Value) {
    let frame = json!({"origin": [1.0, 2.0, 3.0], "x": [1.0, 0.0, 0.0], "z": [0.0, 0.0, 1.0]});
    let written = |text: &str, value: Value| (text.to_owned(), value);
    match kind {
        Kind::Real if name == "pressure_angle_deg" => written("25", json!(25.0)),
        Kind::Real if name == "profile_shift" => written("0.25", json!(0.25)),
        Kind::Real if name == "thinning" => written("0.125", json!(0.125)),
        Kind::Real => written("2", json!(2.0)),
        Kind::Count => written("20", json!(20)),
        Kind::Flag => written("True", json!(true)),
        Kind::Text if name == "type" => written("\"HOLE\"", json!("HOLE")),
        Kind::Text => written("\"a_name\"", json!("a_name")),
        Kind::Choice(choices) => (format!("{:?}", choices[0]), json!(choices[0])),
        Kind::Vector => written("(1, 2)", json!([1.0, 2.0, 0.0])),
        Kind::Vectors => written(
            "[(1, 2), cq.Vector(3, 4, 5)]",
            json!([[1.0, 2.0, 0.0], [3.0, 4.0, 5.0]]),
        ),
        Kind::MaybeVectors => written("[(1, 2), None]", json!([[1.0, 2.0, 0.0], null])),
        Kind::Reals => written("(1, 2.5)", json!([1.0, 2.5])),
        Kind::Flags2 => written("(True, False)", json!([true, false])),
        Kind::Flags3 => written("(True, False, True)", json!([true, false, true])),
        Kind::Combine => written("\"s\"", json!("cut")),
        Kind::Selector => written("\"|Z\"", json!({"parallel": [0.0, 0.0, 1.0]})),
        Kind::Until => written("s", json!({"ref": 1})),
        Kind::Plane | Kind::PlaneOrShape => written("cq.Plane((1, 2, 3), (5, 0, 0))", frame),
        Kind::MirrorPlane => written("(0, 0, 1)", json!([0.0, 0.0, 1.0])),
        Kind::Location => written("cq.Location((1, 2, 3))", frame),
        Kind::Places => written(
            "[(1, 2), cq.Location((1, 2, 3))]",
            json!([[1.0, 2.0, 0.0], frame]),
        ),
        Kind::Workplane => written("w", json!({"ref": 0})),
        Kind::Solid | Kind::PerLocation => written("s", json!({"ref": 1})),
        Kind::Solids => written("[s, w]", json!([{"ref": 1}, {"ref": 0}])),
        Kind::PerObject => written("lambda o: o.clean()", json!({"ref": 3})),
        Kind::PortParams => written(
            "{\"diameter\": 3, \"depth\": 4}",
            json!({"diameter": 3.0, "depth": 4.0}),
        ),
        Kind::Outline => written("cq.involute(1, 20)", Value::Null),
    }
}

fn default(param: &Param) -> Option<Value> {
    Some(match (param.default, param.kind) {
        (Default::Required | Default::None, _) => return None,
        (Default::Flag(b), Kind::Flags2) => json!([b, b]),
        (Default::Flag(b), Kind::Flags3) => json!([b, b, b]),
        (Default::Flag(true), Kind::Combine) => json!("add"),
        (Default::Flag(false), Kind::Combine) => json!("none"),
        (Default::Flag(b), _) => json!(b),
        (Default::Real(n), _) => json!(n),
        (Default::Count(n), _) => json!(n),
        (Default::Text(t), _) => json!(t),
        (Default::Vector(v), _) => json!(v),
    })
}

/// Calls each method with the parameters that `given` picks, by name or by place.
fn all(by_name: bool, given: fn(&Param) -> bool) {
    for m in methods().filter(|m| !m.name.starts_with("each")) {
        let receiver = match m.on {
            None => "cq",
            Some(Type::Workplane) => "w",
            Some(Type::Shape) => "s",
            Some(other) => panic!("{other:?} has methods"),
        };
        let called = match m.on {
            None => m.name,
            Some(_) => m.short(),
        };
        let hidden = |p: &Param| m.name == "Workplane.gear_mesh_port" && p.name == "outline";
        let (mut written, mut expected) = (Vec::new(), serde_json::Map::new());
        for param in m.params.iter().filter(|p| !hidden(p)) {
            let (text, value) = sample(param.kind, param.name);
            if given(param) {
                written.push(if by_name {
                    format!("{}={text}", param.name)
                } else {
                    text
                });
                expected.insert(param.name.to_owned(), value);
            } else if let Some(value) = default(param) {
                expected.insert(param.name.to_owned(), value);
            }
        }
        if m.name == "Workplane.each" {
            expected.insert("variable".to_owned(), json!({"ref": 2}));
        }
        let source = format!(
            "w = cq.Workplane()\ns = w.val()\n_ = {receiver}.{called}({})\nresult = w\n",
            written.join(", ")
        );
        let done = script("table", &source).unwrap_or_else(|e| panic!("{source}{e:?}"));
        let call = done.recipe.calls.last().unwrap();
        assert_eq!(call.call, m.name, "{source}");
        assert_eq!(*done.lines.last().unwrap(), 3);
        let on = match m.on {
            None => None,
            Some(Type::Workplane) => Some(0),
            Some(_) => Some(1),
        };
        assert_eq!(call.on, on);
        let mut args = serde_json::to_value(&call.args).unwrap();
        if let Some(outline) = args.get_mut("outline") {
            assert!(outline["segments"].as_array().unwrap().len() > 20 * 4);
            let outline = outline.take();
            expected.insert("outline".to_owned(), Value::Null);
            drop(outline);
        }
        assert_eq!(args, Value::Object(expected), "{source}");
    }
}

#[test]
fn required_arguments_and_defaults() {
    all(false, |p| p.default == Default::Required);
    all(true, |p| p.default == Default::Required);
}

#[test]
fn every_argument_by_name_and_by_place() {
    all(true, |_| true);
    all(false, |_| true);
}

#[test]
fn misuse_of_every_method_is_answered() {
    for m in methods().filter(|m| m.on == Some(Type::Workplane) && !m.name.starts_with("each")) {
        let call = |args: &str| {
            let source = format!("w = cq.Workplane()\nresult = w.{}({args})\n", m.short());
            script("table", &source)
        };
        let unknown = call("nonsense=1").unwrap_err().remove(0);
        assert!(
            unknown.message.contains("no parameter 'nonsense'"),
            "{unknown}"
        );
        assert_eq!(unknown.place, "factory table, line 2");
        assert!(unknown.hint.unwrap().contains(&format!("{}(", m.short())));
        let many = call(&["1"; 20].join(", ")).unwrap_err().remove(0);
        assert!(many.message.contains("and 20 are given"), "{many}");
        let required = m.params.iter().find(|p| p.default == Default::Required);
        if let Some(required) = required {
            let missing = call("").unwrap_err().remove(0);
            assert!(missing.message.contains("lacks"), "{missing}");
            assert!(missing.message.contains(required.name), "{missing}");
        }
        // No parameter takes a dict but one.
        for param in m.params.iter().filter(|p| p.kind != Kind::PortParams) {
            if m.name == "Workplane.gear_mesh_port" && param.name == "outline" {
                continue;
            }
            let mut args: Vec<String> = m
                .params
                .iter()
                .filter(|p| p.default == Default::Required && p.name != param.name)
                .map(|p| {
                    let text = match p.kind {
                        Kind::Solid | Kind::Solids | Kind::PerLocation | Kind::Until => "w".into(),
                        kind => sample(kind, p.name).0,
                    };
                    format!(
                        "{}={}",
                        p.name,
                        if p.kind == Kind::Until {
                            "1".into()
                        } else {
                            text
                        }
                    )
                })
                .collect();
            args.push(format!("{}={{}}", param.name));
            let wrong = call(&args.join(", ")).unwrap_err().remove(0);
            assert!(wrong.message.contains(param.name), "{}: {wrong}", m.name);
        }
    }
    assert!(method("Workplane.box").is_some());
}
