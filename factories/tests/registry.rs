//! The registry: names, unknown names, folders of factories, descriptions.
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    clippy::indexing_slicing,
    reason = "helpers of tests, outside of #[test] functions"
)]

use assemcad_factories::{Registry, is_valid_name};
use assemcad_model::diagnostic::Code;
use serde_json::{Map, json};

#[test]
fn names_are_sorted_and_valid() {
    let (registry, found) = Registry::load(None);
    assert!(found.is_empty(), "{found:?}");
    let names = registry.names();
    assert_eq!(
        names,
        [
            "base_frame.housing_block",
            "base_frame.rect_plate",
            "base_frame.stepped_shaft",
            "bearing.ball",
            "gear.spur"
        ]
    );
    assert!(names.iter().all(|n| is_valid_name(n)));
    for bad in ["plate", "a.", ".a", "a.b.c", "a/b.c", "../a.b"] {
        assert!(!is_valid_name(bad), "{bad}");
    }
}

#[test]
fn an_unknown_name_answers_with_the_nearest_ones() {
    let d = *Registry::builtin().get("base_frame.plate").unwrap_err();
    assert_eq!(d.code, Code::FactoryUnknown);
    assert!(
        d.hint.as_deref().unwrap().contains("base_frame.rect_plate"),
        "{d:?}"
    );
    assert_eq!(d.expected.unwrap(), json!(Registry::builtin().names()));
    assert_eq!(d.next.unwrap().tool, "list_factories");
}

#[test]
fn a_description_says_everything() {
    for name in Registry::builtin().names() {
        let d = Registry::builtin().describe(name).unwrap();
        assert_eq!(d.source_sha256.len(), 64);
        assert_eq!(d.schema["additionalProperties"], json!(false));
        assert!(
            d.doc.contains("Frame:") && d.doc.contains("Ports"),
            "{name}"
        );
        for port in &d.ports {
            // Numbered ports are documented by the first of them.
            assert!(
                d.doc.contains(&port.name) || port.name.starts_with("shaft_seat_"),
                "{name} {}",
                port.name
            );
        }
        for param in &d.params {
            assert!(!param.doc.is_empty(), "{name} {}", param.name);
        }
    }
}

#[test]
fn the_same_question_gets_the_same_answer() {
    let r = Registry::builtin();
    let a = r.build("bearing.ball", &Map::new()).unwrap();
    let given = json!({"width": 14, "d_o": 47.0, "d_i": 20})
        .as_object()
        .unwrap()
        .clone();
    let b = r.build("bearing.ball", &given).unwrap();
    assert!(std::sync::Arc::ptr_eq(&a, &b));
}

#[test]
fn a_bad_file_does_not_stop_the_rest() {
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str, text: &str| std::fs::write(folder.path().join(name), text).unwrap();
    let good = "factory(doc = \"cube\", params = {})\ndef build(p):\n    return box(1, 1, 1)\n";
    write("my.cube.star", good);
    write("my.bad.star", "while True:\n    pass\n");
    write("bearing.ball.star", good);
    write("cube.star", good);
    write("readme.md", "nothing");
    let (registry, found) = Registry::load(Some(folder.path()));
    assert_eq!(
        registry.names().len(),
        Registry::builtin().names().len() + 1
    );
    assert_eq!(
        registry
            .build("my.cube", &Map::new())
            .unwrap()
            .recipe
            .ops
            .len(),
        1
    );
    let codes: Vec<Code> = found.iter().map(|d| d.code).collect();
    assert_eq!(
        codes,
        [Code::NameTaken, Code::NameInvalid, Code::FactoryFailed],
        "{found:?}"
    );
    let (registry, found) = Registry::load(Some(&folder.path().join("missing")));
    assert_eq!(registry.names(), Registry::builtin().names());
    assert_eq!(found.len(), 1);
}
