//! What is on disk is whole, and where nothing can be kept, questions are answered all the same.

use std::time::Duration;

use rustix::fs::{FlockOperation, flock};
use serde_json::{Value, json};

use crate::kit::Kit;

#[test]
fn where_nothing_can_be_kept_questions_are_answered() {
    let mut kit = Kit::new();
    kit.stand("stand");
    kit.ok("list_assemblies", json!({}));
    // What would be written has something in its way; nothing else differs from a disk that is full.
    let _ = std::fs::remove_dir_all(kit.file(".assemcad"));
    std::fs::write(kit.file(".assemcad"), "in the way").unwrap();
    for name in ["report.json", "stand-isometric.png"] {
        std::fs::create_dir(kit.file(&format!("assemblies/stand/{name}"))).unwrap();
    }
    let before = kit.files();

    let report = kit.ok("verify", json!({"assembly": "stand"}));
    assert!(
        report["not_kept"]
            .as_str()
            .unwrap()
            .contains("could not be kept"),
        "{report}"
    );
    assert_eq!(report.get("report_file"), None);
    assert!(report["findings_total"].as_u64().is_some());

    let checked = kit.ok(
        "validate_draft",
        json!({"draft": "assembly: {id: x, parts: []}"}),
    );
    let found = checked["diagnostics"].as_array().unwrap();
    let warned = |d: &Value| d["message"].as_str().unwrap().contains("could not be kept");
    assert!(found.iter().any(warned), "{checked}");
    assert_eq!(checked["round"], 1);

    let measured = kit.ok(
        "measure",
        json!({"assembly": "stand", "what": "box", "of": "plate"}),
    );
    assert!(measured.to_string().contains("box"), "{measured}");

    let arguments = json!({"assembly": "stand", "file": true});
    let picture = kit.session.call("render", arguments).unwrap();
    assert!(!picture.is_error, "{:?}", picture.content);
    let caption = picture.blocks[0]["text"].as_str().unwrap();
    assert!(caption.contains("No file was kept"), "{caption}");
    assert_eq!(picture.blocks[1]["type"], "image");
    assert_eq!(kit.files(), before);
}

#[test]
fn exports_take_the_place_of_nothing_else() {
    let mut kit = Kit::new();
    kit.stand("stand");
    kit.new_assembly("a");
    kit.part("a", "p", "base_frame.rect_plate", json!({}));
    kit.ok("export_step", json!({"assembly": "a"}));
    std::fs::write(kit.file("mine.step"), "mine").unwrap();
    let before = kit.files();
    for file in [
        "assemblies/a/a.step",
        ".assemcad/x.step",
        "mine.step",
        "exports/a/x.stp",
    ] {
        let step = kit.ok("export_step", json!({"assembly": "stand", "file": file}));
        assert_eq!(step["file"], format!("exports/stand/{file}"));
    }
    for (name, bytes) in &before {
        assert_eq!(kit.files().get(name), Some(bytes), "{name}");
    }
    // The name that the answer gave means the same place.
    let again = json!({"assembly": "stand", "file": "exports/stand/mine.step"});
    assert_eq!(
        kit.ok("export_step", again)["file"],
        "exports/stand/mine.step"
    );
}

#[test]
fn a_report_is_not_written_while_another_holds_the_assembly() {
    let mut kit = Kit::new();
    kit.new_assembly("a");
    kit.part("a", "p", "base_frame.rect_plate", json!({}));
    let folder = std::fs::File::open(kit.file("assemblies/a")).unwrap();
    flock(&folder, FlockOperation::LockExclusive).unwrap();
    let verify = kit
        .session
        .begin_call("verify", json!({"assembly": "a"}))
        .unwrap();
    std::thread::sleep(Duration::from_secs(3));
    assert!(kit.session.answered(verify).is_none());
    assert!(!kit.file("assemblies/a/report.json").exists());
    // Changed by whoever holds it: what was verified is not what is there any more.
    let path = kit.file("assemblies/a/assembly.yaml");
    let text = std::fs::read_to_string(&path).unwrap();
    std::fs::write(&path, text.replace("id: p", "id: q")).unwrap();
    drop(folder);
    let report = kit.session.wait_call(verify).unwrap().content;
    assert!(
        report["not_kept"]
            .as_str()
            .unwrap()
            .contains("changed while"),
        "{report}"
    );
    assert!(!kit.file("assemblies/a/report.json").exists());
}

#[test]
fn what_a_killed_write_left_goes_at_the_next_start() {
    let mut kit = Kit::new();
    kit.stand("stand");
    let before = kit.files();
    let left = kit.file("assemblies/stand/.assembly.yaml.123456-7");
    std::fs::write(&left, "half").unwrap();
    let kit = kit.killed_and_started_again();
    assert!(!left.exists());
    assert_eq!(kit.files(), before);
}

#[test]
fn wrong_drafts_without_a_name_are_counted_for_each_client() {
    let mut kit = Kit::new();
    for i in 0..7 {
        let draft = format!("assembly: {{parts: [], round: {i}}}");
        let answer = kit
            .session
            .call("validate_draft", json!({"draft": draft}))
            .unwrap();
        assert_eq!(answer.is_error, i >= 4, "{i}");
    }
    let root = kit.root();
    let mut other = crate::harness::Session::start(crate::kit::program(), &root, &[]).unwrap();
    let draft = json!({"draft": "assembly: {parts: [], of: another}"});
    let answer = other.call("validate_draft", draft).unwrap();
    assert!(!answer.is_error, "{}", answer.content);
    assert_eq!(answer.content["round"], 1);
}
