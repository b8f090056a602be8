//! The registry: names, unknown names, folders of factories, descriptions.
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    clippy::indexing_slicing,
    reason = "helpers of tests, outside of #[test] functions"
)]

use assemcad_factories::{Evaluated, Registry, is_valid_name};
use assemcad_model::diagnostic::{Code, Diagnostic};
use assemcad_script::Evaluator;
use serde_json::{Map, Value, json};

fn load(extra: Option<&std::path::Path>) -> (Registry, Vec<Diagnostic>) {
    futures::executor::block_on(Registry::load(extra, &Evaluator::here()))
}

fn build(
    registry: &Registry,
    name: &str,
    params: &Map<String, Value>,
) -> Result<std::sync::Arc<Evaluated>, Vec<Diagnostic>> {
    futures::executor::block_on(registry.build(&Evaluator::here(), name, params))
}

#[test]
fn names_are_sorted_and_valid() {
    let (registry, found) = load(None);
    assert!(found.is_empty(), "{found:?}");
    let names = registry.names();
    assert_eq!(
        names,
        [
            "base_frame.bolt_circle_flange",
            "base_frame.boss",
            "base_frame.coupling_hub",
            "base_frame.housing_block",
            "base_frame.l_bracket",
            "base_frame.rect_plate",
            "base_frame.stepped_shaft",
            "base_frame.u_channel",
            "bearing.ball",
            "fastener.bolt",
            "fastener.nut",
            "fastener.washer",
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
    for factory in Registry::builtin().all() {
        let name = factory.name();
        assert_eq!(factory.source_sha256().len(), 64);
        assert_eq!(factory.schema()["additionalProperties"], json!(false));
        let doc = factory.doc();
        assert!(doc.contains("Frame:") && doc.contains("Ports"), "{name}");
        for param in factory.params() {
            assert!(!param.doc.is_empty(), "{name} {}", param.name);
        }
    }
}

#[test]
fn the_same_question_gets_the_same_answer() {
    let r = Registry::builtin();
    let a = build(r, "bearing.ball", &Map::new()).unwrap();
    let given = json!({"width": 14, "d_o": 47.0, "d_i": 20})
        .as_object()
        .unwrap()
        .clone();
    let b = build(r, "bearing.ball", &given).unwrap();
    assert!(std::sync::Arc::ptr_eq(&a, &b));
}

#[test]
fn a_bad_file_does_not_stop_the_rest() {
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str, text: &str| std::fs::write(folder.path().join(name), text).unwrap();
    let good = "factory(doc = \"cube\", params = {})\ndef build(p):\n    return cq.Workplane().box(1, 1, 1)\n";
    write("my.cube.star", good);
    write("my.bad.star", "while True:\n    pass\n");
    write("bearing.ball.star", good);
    write("cube.star", good);
    write("readme.md", "nothing");
    let (registry, found) = load(Some(folder.path()));
    assert_eq!(
        registry.names().len(),
        Registry::builtin().names().len() + 1
    );
    assert_eq!(
        build(&registry, "my.cube", &Map::new())
            .unwrap()
            .recipe
            .calls
            .len(),
        2
    );
    let codes: Vec<Code> = found.iter().map(|d| d.code).collect();
    assert_eq!(
        codes,
        [Code::NameTaken, Code::NameInvalid, Code::FactoryFailed],
        "{found:?}"
    );
    let (registry, found) = load(Some(&folder.path().join("missing")));
    assert_eq!(registry.names(), Registry::builtin().names());
    assert_eq!(found.len(), 1);
}
