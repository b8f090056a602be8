//! Sound assemblies and what was broken in each: read from the folder, broken, and put before a server.

use std::collections::BTreeSet;
use std::path::Path;

use assemcad_model::yaml;
use serde_json::{Map, Value, json};

use crate::harness::Session;

/// An assembly, sound or with one defect.
pub struct Case {
    /// File and name.
    pub id: String,
    /// What kind of defect it is; none of a sound one.
    pub mechanism: Option<String>,
    /// `honest`, or `dodge` where the text hides it.
    pub form: String,
    /// Why it is right, or wrong.
    pub why: String,
    /// The parts of which at least one must be named.
    pub at: BTreeSet<String>,
    assembly: Value,
    tau_mm3: Option<f64>,
}

/// What a server says of a case.
#[derive(Debug, PartialEq, Eq)]
pub enum Told {
    /// It passes.
    Pass,
    /// It fails at one of the parts at which it is wrong, or is not taken in at all.
    Found,
    /// It fails for another reason.
    Elsewhere(String),
    /// It was left open.
    Open(String),
}

/// All cases of a folder, in order.
pub fn cases(folder: &Path) -> Vec<Case> {
    let mut files: Vec<_> = std::fs::read_dir(folder)
        .unwrap()
        .map(|e| e.unwrap().path())
        .filter(|p| p.extension().is_some_and(|e| e == "yaml"))
        .collect();
    files.sort();
    files.iter().flat_map(|f| of_file(f)).collect()
}

fn of_file(path: &Path) -> Vec<Case> {
    let name = path.file_stem().unwrap().to_str().unwrap();
    let text = std::fs::read_to_string(path).unwrap();
    let read = yaml::read(&text);
    assert!(read.faults.is_empty(), "{name}: {:?}", read.faults);
    let whole = read.node.unwrap().value(None);
    let base = Case {
        id: format!("{name}/as_it_is"),
        mechanism: None,
        form: String::new(),
        why: word(&whole, "why"),
        at: BTreeSet::new(),
        assembly: named(whole["assembly"].clone(), name),
        tau_mm3: None,
    };
    let list = |key: &str| whole[key].as_array().cloned().unwrap_or_default();
    let mut out = vec![base];
    for case in list("sound").iter().chain(&list("defects")) {
        let mut assembly = whole["assembly"].clone();
        let mut tau_mm3 = None;
        for edit in case["edits"].as_array().unwrap() {
            change(&mut assembly, edit);
            tau_mm3 = edit.get("tau_mm3").and_then(Value::as_f64).or(tau_mm3);
        }
        forget(&mut assembly);
        let at = case["at"].as_array().cloned().unwrap_or_default();
        out.push(Case {
            id: format!("{name}/{}", word(case, "id")),
            mechanism: case["mechanism"].as_str().map(str::to_owned),
            form: word(case, "form"),
            why: word(case, "why"),
            at: at.iter().map(|p| p.as_str().unwrap().to_owned()).collect(),
            assembly: named(assembly, &format!("{name}_{}", word(case, "id"))),
            tau_mm3,
        });
    }
    out
}

fn word(of: &Value, key: &str) -> String {
    of[key].as_str().unwrap_or_default().to_owned()
}

fn named(mut assembly: Value, name: &str) -> Value {
    assembly["id"] = json!(name);
    assembly
}

/// One edit: parameters of a part, fields of a mate, parts and mates away or more of them, what is stated.
fn change(assembly: &mut Value, edit: &Value) {
    let merge = |into: &mut Value, more: &Value| {
        let into = into.as_object_mut().unwrap();
        for (key, value) in more.as_object().unwrap() {
            into.insert(key.clone(), value.clone());
        }
    };
    let find = |list: &mut Value, id: &Value| -> Option<usize> {
        list.as_array().unwrap().iter().position(|x| x["id"] == *id)
    };
    if let Some(id) = edit.get("part") {
        let i = find(&mut assembly["parts"], id).unwrap();
        merge(&mut assembly["parts"][i]["params"], &edit["params"]);
        if let Some(elastic) = edit.get("elastic") {
            assembly["parts"][i]["elastic"] = elastic.clone();
        }
    }
    if let Some(id) = edit.get("mate")
        && let Some(i) = find(&mut assembly["mates"], id)
    {
        let mate = &mut assembly["mates"][i];
        if let Some(options) = edit.get("options") {
            if mate.get("options").is_none() {
                mate["options"] = json!({});
            }
            merge(&mut mate["options"], options);
        }
        if let Some(notes) = edit.get("notes") {
            mate["notes"] = notes.clone();
        }
    }
    for id in edit["remove"].as_array().into_iter().flatten() {
        let parts = assembly["parts"].as_array_mut().unwrap();
        parts.retain(|p| p["id"] != *id);
        let mates = assembly["mates"].as_array_mut().unwrap();
        mates.retain(|m| m["id"] != *id && m["base"]["ref"] != *id && m["incoming"]["ref"] != *id);
    }
    for (key, list) in [("add_parts", "parts"), ("add_mates", "mates")] {
        let more = edit[key].as_array().cloned().unwrap_or_default();
        assembly[list].as_array_mut().unwrap().extend(more);
    }
    if let Some(more) = edit.get("assembly") {
        merge(assembly, more);
    }
}

/// What is stated of parts that went is taken away with them.
fn forget(assembly: &mut Value) {
    let ids: BTreeSet<String> = assembly["parts"]
        .as_array()
        .unwrap()
        .iter()
        .map(|p| word(p, "id"))
        .collect();
    let stated: &mut Map<String, Value> = assembly.as_object_mut().unwrap();
    for key in ["intended_motions", "free"] {
        if let Some(Value::Array(list)) = stated.get_mut(key) {
            list.retain(|m| ids.contains(&word(m, "part")));
        }
    }
}

impl Case {
    /// Puts the case before a server.
    pub fn put(&self, session: &mut Session) -> Told {
        let draft = json!({"assembly": self.assembly}).to_string();
        let mut call = json!({"draft": draft, "keep_failed": true});
        let mut again = json!({"assembly": self.assembly["id"], "detail": "full"});
        if let Some(tau) = self.tau_mm3 {
            call["tau_mm3"] = json!(tau);
            again["tau_mm3"] = json!(tau);
        }
        let realized = session.call("realize", call).unwrap();
        let report = session.call("verify", again).unwrap();
        let Some(verdict) = report.content["verdict"].as_str() else {
            // It is not taken in: the diagnostics say why.
            let said = realized.content["stages"][0]["diagnostics"].to_string();
            return match self.mechanism {
                Some(_) => Told::Found,
                None => Told::Elsewhere(said),
            };
        };
        let findings = report.content["findings"].as_array().unwrap();
        let said = |wanted: &str| {
            let of = findings.iter().filter(|f| f["verdict"] == wanted);
            let said: Vec<String> = of
                .map(|f| {
                    let message = f["diagnostic"]["message"].as_str().unwrap();
                    format!("{}: {message}", f["check"].as_str().unwrap())
                })
                .collect();
            said.join("; ")
        };
        let there = findings.iter().filter(|f| f["verdict"] == "fail").any(|f| {
            let parts = f["parts"].as_array().unwrap();
            parts.iter().any(|p| self.at.contains(p.as_str().unwrap()))
        });
        match verdict {
            "pass" => Told::Pass,
            "indeterminate" => Told::Open(said("indeterminate")),
            _ if there => Told::Found,
            _ => Told::Elsewhere(said("fail")),
        }
    }
}
