//! Every accepted change is on disk before it is answered.

use serde_json::json;

use crate::harness::Session;
use crate::kit::{Kit, program};

#[test]
fn a_server_started_again_offers_the_assembly_as_it_was() {
    let mut kit = Kit::new();
    kit.whole_stand("stand");
    let before = kit.ok(
        "get_assembly",
        json!({"assembly": "stand", "detail": "full"}),
    );
    let mut kit = kit.killed_and_started_again();
    assert_eq!(
        kit.ok("list_assemblies", json!({}))["assemblies"],
        json!(["stand"])
    );
    assert_eq!(
        kit.ok(
            "get_assembly",
            json!({"assembly": "stand", "detail": "full"})
        ),
        before
    );
    assert_eq!(
        kit.ok("verify", json!({"assembly": "stand"}))["verdict"],
        "pass"
    );
}

#[test]
fn every_answered_change_survives_a_kill() {
    let mut kit = Kit::new();
    kit.new_assembly("a");
    for i in 0..4 {
        kit.part("a", &format!("p{i}"), "test.block", json!({}));
        kit = kit.killed_and_started_again();
        let state = kit.ok("get_assembly", json!({"assembly": "a"}));
        assert_eq!(state["state"]["parts"].as_array().unwrap().len(), i + 1);
    }
}

#[test]
fn two_servers_over_one_folder_lose_nothing() {
    let root = tempfile::tempdir().unwrap();
    let mut servers = [(); 2].map(|()| Session::start(program(), root.path(), &[]).unwrap());
    servers[0]
        .call("new_assembly", json!({"assembly": "a"}))
        .unwrap();
    let mut calls = Vec::new();
    for i in 0..6 {
        for (s, server) in servers.iter_mut().enumerate() {
            let part = json!({
                "assembly": "a", "part": format!("p{s}{i}"), "factory": "base_frame.rect_plate",
            });
            calls.push((s, server.begin_call("add_part", part).unwrap()));
        }
    }
    for (s, call) in calls {
        assert!(!servers[s].wait_call(call).unwrap().is_error);
    }
    let state = servers[1]
        .call("get_assembly", json!({"assembly": "a"}))
        .unwrap()
        .content;
    assert_eq!(state["state"]["parts"].as_array().unwrap().len(), 12);
}

#[test]
fn a_damaged_specification_is_told_and_left_alone() {
    let mut kit = Kit::new();
    kit.stand("stand");
    let path = kit.file("assemblies/stand/assembly.yaml");
    let good = std::fs::read_to_string(&path).unwrap();
    for bad in [
        "",
        "{}",
        &good[..good.len() / 2],
        &good.replace("id: stand\n", "id: other\n"),
    ] {
        std::fs::write(&path, bad).unwrap();
        let call = json!({"assembly": "stand", "part": "x", "factory": "test.block"});
        assert_eq!(kit.refusal("add_part", call)["code"], "file_damaged");
        assert_eq!(std::fs::read_to_string(&path).unwrap(), bad);
    }
    std::fs::write(&path, good).unwrap();
    kit.ok("get_assembly", json!({"assembly": "stand"}));
}

#[test]
fn a_damaged_cached_solid_is_made_anew() {
    let mut kit = Kit::new();
    kit.stand("stand");
    let before = kit.ok("export_step", json!({"assembly": "stand"}))["sha256"].clone();
    let cache = kit.file(".assemcad/cache");
    let entries = || -> Vec<(std::path::PathBuf, Vec<u8>)> {
        let paths = std::fs::read_dir(&cache)
            .unwrap()
            .map(|e| e.unwrap().path())
            .filter(|p| p.extension().is_some_and(|e| e == "solid"));
        let mut all: Vec<_> = paths
            .map(|p| (p.clone(), std::fs::read(p).unwrap()))
            .collect();
        all.sort();
        all
    };
    let good = entries();
    assert_eq!(good.len(), 4);
    for (i, (path, bytes)) in good.iter().enumerate() {
        let mut bad = bytes.clone();
        match i {
            0 => bad.truncate(bad.len() / 2),
            1 => bad.clear(),
            2 => {
                let middle = bad.len() / 2;
                bad[middle] ^= 0x10;
            }
            _ => bad.extend(b"more"),
        }
        std::fs::write(path, bad).unwrap();
    }
    let mut kit = kit.killed_and_started_again();
    assert_eq!(
        kit.ok("export_step", json!({"assembly": "stand"}))["sha256"],
        before
    );
    assert_eq!(entries(), good, "the entries were not mended");
}

#[test]
fn the_specification_is_text_that_people_can_read() {
    let mut kit = Kit::new();
    kit.stand("stand");
    let text = std::fs::read_to_string(kit.file("assemblies/stand/assembly.yaml")).unwrap();
    assert_eq!(
        text,
        "format: 1
assembly:
  id: stand
  parts:
    - id: plate
      factory: base_frame.rect_plate
      params: {}
    - id: block
      factory: base_frame.housing_block
      params: {}
    - id: bearing
      factory: bearing.ball
      params: {}
    - id: shaft
      factory: base_frame.stepped_shaft
      params: {}
  mates:
    - id: m1
      mate_type: face_to_face
      base: {ref: plate, port: top_face}
      incoming: {ref: block, port: bottom_face}
      options: {bond: welded}
      axioms: [C-01]
    - id: m2
      mate_type: coaxial
      base: {ref: block, port: bore_port}
      incoming: {ref: bearing, port: outer_ring}
      options: {d_mm: -7.0, direction: same}
      axioms: [B-01, C-02]
    - id: m3
      mate_type: coaxial
      base: {ref: bearing, port: inner_ring}
      incoming: {ref: shaft, port: shaft_seat_1}
      options: {d_mm: -30.0, direction: same}
      axioms: [C-02, P-01]
"
    );
}

#[test]
fn comments_in_a_stored_file_are_lost_with_a_warning() {
    let mut kit = Kit::new();
    kit.stand("stand");
    let path = kit.file("assemblies/stand/assembly.yaml");
    let text = std::fs::read_to_string(&path).unwrap();
    std::fs::write(
        &path,
        text.replace("  mates:\n", "  # how it hangs together\n  mates:\n"),
    )
    .unwrap();
    kit.ok("verify", json!({"assembly": "stand"}));
    assert!(std::fs::read_to_string(&path).unwrap().contains('#'));
    let answer = kit.part("stand", "x", "test.block", json!({}));
    let warning = &answer["state"]["warnings"][0];
    assert_eq!(warning["code"], "comment_lost");
    assert_eq!(warning["where"], "assemblies/stand/assembly.yaml, line 17");
    let answer = kit.part("stand", "y", "test.block", json!({}));
    assert!(answer["state"].get("warnings").is_none());
}
