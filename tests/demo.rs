//! The demo: an MCP session over a real child process. A shaft in two ball bearings in a block on a
//! base plate, from tool calls to a verified STEP file. Each call is printed with its answer in short.

// A program of its own: its standard output is for people.
#![allow(clippy::print_stdout)]

// Other sessions use more of it.
#[allow(dead_code)]
mod harness;

use std::path::PathBuf;
use std::process::ExitCode;

use harness::Session;
use serde_json::{Value, json};

const ASSEMBLY: &str = "bearing_stand";

fn main() -> ExitCode {
    match run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(why) => {
            eprintln!("demo: {why}");
            ExitCode::FAILURE
        }
    }
}

fn run() -> Result<(), String> {
    let root = PathBuf::from(std::env::args().nth(1).unwrap_or_else(|| "out".to_owned()));
    // The demo shows an assembly being made, so it starts without the one of the last run.
    let folder = root.join("assemblies").join(ASSEMBLY);
    if folder.exists() {
        std::fs::remove_dir_all(&folder).map_err(|e| format!("{}: {e}", folder.display()))?;
    }
    let here = std::env::current_exe().map_err(|e| e.to_string())?;
    let program = here
        .ancestors()
        .nth(2)
        .map(|p| p.join("assemcad"))
        .ok_or("no program")?;
    let mut session = Session::start(&program, &root, &[])?;
    for (tool, arguments) in script() {
        println!("> {tool} {arguments}");
        let answer = session.call(tool, arguments)?;
        match answer.blocks.pointer("/0/text").and_then(Value::as_str) {
            // A picture's caption; of every other answer the text is the whole object once more.
            Some(caption) if answer.content.is_null() => {
                println!("  {}", caption.replace('\n', "\n  "));
            }
            _ => println!("  {}", short(tool, &answer.content)),
        }
        if answer.is_error {
            return Err(format!("{tool} failed"));
        }
        if tool == "verify" && answer.content.get("verdict") != Some(&json!("pass")) {
            return Err("the assembly does not verify".to_owned());
        }
    }
    session.close()?;
    println!("\nleft in {}:", folder.display());
    for name in [
        "assembly.yaml",
        "report.json",
        "bearing_stand.step",
        "bearing_stand-isometric.png",
    ] {
        let size = std::fs::metadata(folder.join(name))
            .map_err(|e| format!("{name}: {e}"))?
            .len();
        println!("  {name} ({size} bytes)");
    }
    Ok(())
}

/// What an agent calls for "a shaft in a bearing block on a base plate".
fn script() -> Vec<(&'static str, Value)> {
    let part = |part: &str, factory: &str, params: Value| {
        (
            "add_part",
            json!({"assembly": ASSEMBLY, "part": part, "factory": factory, "params": params}),
        )
    };
    let mate = |id: &str, mate_type: &str, ends: [&str; 2], axioms: &[&str], options: Value| {
        let mut call = json!({
            "assembly": ASSEMBLY, "id": id, "mate_type": mate_type, "base": ends[0], "incoming": ends[1],
            "axioms": axioms,
        });
        if let (Some(call), Value::Object(options)) = (call.as_object_mut(), options) {
            call.extend(options);
        }
        ("mate", call)
    };
    vec![
        ("list_factories", json!({})),
        ("describe_factory", json!({"factory": "bearing.ball"})),
        (
            "find_axioms",
            json!({"mate_type": "coaxial", "classes": ["bearing/ball"]}),
        ),
        (
            "new_assembly",
            json!({"assembly": ASSEMBLY, "description": "A shaft in a bearing block on a base plate"}),
        ),
        part(
            "plate",
            "base_frame.rect_plate",
            json!({"length": 200, "width": 120, "thickness": 15}),
        ),
        part(
            "block",
            "base_frame.housing_block",
            json!({"length": 80, "width": 50, "height": 80, "bore_d": 47}),
        ),
        part(
            "bearing_front",
            "bearing.ball",
            json!({"d_i": 20, "d_o": 47, "width": 14}),
        ),
        part(
            "bearing_back",
            "bearing.ball",
            json!({"d_i": 20, "d_o": 47, "width": 14}),
        ),
        part(
            "shaft",
            "base_frame.stepped_shaft",
            json!({"segments": [{"d": 20, "length": 60}, {"d": 26, "length": 22}, {"d": 20, "length": 40}]}),
        ),
        mate(
            "block_on_plate",
            "face_to_face",
            ["plate:top_face", "block:bottom_face"],
            &["C-01"],
            json!({"bond": "welded"}),
        ),
        // Each bearing flush with its end of the bore: its middle half its width behind the mouth.
        mate(
            "front_in_block",
            "press_fit",
            ["block:bore_port", "bearing_front:outer_ring"],
            &["B-01", "C-03"],
            json!({"d_mm": -7, "direction": "same"}),
        ),
        mate(
            "back_in_block",
            "press_fit",
            ["block:bore_port_back", "bearing_back:outer_ring"],
            &["B-01", "C-03"],
            json!({"d_mm": -7, "direction": "same"}),
        ),
        // The shaft's collar fills the 22 mm between the rings, which hold it both ways: the seat behind it
        // begins where the front ring does, and its middle is 6 mm before the ring's mouth.
        mate(
            "shaft_in_front",
            "coaxial",
            ["bearing_front:inner_ring", "shaft:shaft_seat_3"],
            &["B-03", "P-01"],
            json!({"d_mm": 6, "direction": "same"}),
        ),
        // Both parts have a place already: this one is checked.
        mate(
            "shaft_in_back",
            "coaxial",
            ["bearing_back:inner_ring", "shaft:shaft_seat_1"],
            &["P-01"],
            json!({}),
        ),
        (
            "state_intent",
            json!({"assembly": ASSEMBLY, "intended_motions": [{"part": "shaft", "turns_about": "y"}]}),
        ),
        ("verify", json!({"assembly": ASSEMBLY})),
        ("export_step", json!({"assembly": ASSEMBLY})),
        ("render", json!({"assembly": ASSEMBLY, "file": true})),
        ("get_assembly", json!({"assembly": ASSEMBLY})),
    ]
}

/// An answer in a line or two.
fn short(tool: &str, content: &Value) -> String {
    if let Some(faults) = content.get("diagnostics").and_then(Value::as_array) {
        return faults
            .iter()
            .map(Value::to_string)
            .collect::<Vec<_>>()
            .join("\n  ");
    }
    let names = |list: &str, key: &str| {
        let items = content.pointer(list).and_then(Value::as_array);
        let name = |v: &Value| {
            v.get(key)
                .unwrap_or(v)
                .as_str()
                .unwrap_or_default()
                .to_owned()
        };
        items
            .into_iter()
            .flatten()
            .map(name)
            .collect::<Vec<_>>()
            .join(", ")
    };
    let value = |place: &str| {
        content
            .pointer(place)
            .map(Value::to_string)
            .unwrap_or_default()
    };
    match tool {
        "list_factories" => names("/factories", "factory"),
        "find_axioms" => {
            let all = content.get("axioms").and_then(Value::as_array);
            let text = |v: &Value, key: &str| {
                v.get(key)
                    .and_then(Value::as_str)
                    .unwrap_or_default()
                    .to_owned()
            };
            let one = |v: &Value| format!("{} {}", text(v, "axiom"), text(v, "title"));
            let all: Vec<String> = all.into_iter().flatten().map(one).collect();
            format!("{}; {} more", all.join("; "), value("/more"))
        }
        "describe_factory" => format!("ports: {}", names("/ports", "name")),
        "add_part" => {
            format!(
                "{} mm3, ports: {}",
                value("/volume_mm3"),
                names("/ports", "name")
            )
        }
        "mate" => format!(
            "residual {} mm, {} deg; without a place: [{}]",
            value("/residual/distance_mm"),
            value("/residual/angle_deg"),
            names("/state/unplaced", "")
        ),
        "verify" => {
            let checks = content.get("checks").and_then(Value::as_array);
            let check = |c: &Value| {
                let text = |k: &str| {
                    c.get(k)
                        .map(|v| v.to_string().replace('"', ""))
                        .unwrap_or_default()
                };
                format!("{} {} ({})", text("check"), text("verdict"), text("cases"))
            };
            let checks: Vec<String> = checks.into_iter().flatten().map(check).collect();
            let axioms: Vec<String> =
                ["passed", "warned", "not_applicable", "not_checked", "total"]
                    .iter()
                    .map(|k| format!("{k} {}", value(&format!("/axioms/{k}"))))
                    .collect();
            format!(
                "{}: {}\n  axioms: {}",
                value("/verdict"),
                checks.join(", "),
                axioms.join(", ")
            )
        }
        "export_step" => format!(
            "{}: {} products, {} instances, {} bytes, sha256 {}",
            value("/file"),
            value("/products"),
            value("/instances"),
            value("/bytes"),
            value("/sha256")
        ),
        _ => format!("parts: {}", names("/state/parts", "part")),
    }
}
