//! What the sessions share: a server over a folder of its own, its answers held against its schemas.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use serde_json::{Value, json};
use tempfile::TempDir;

use crate::harness::Session;

/// The program under test.
pub fn program() -> &'static Path {
    Path::new(env!("CARGO_BIN_EXE_assemcad"))
}

/// Options, and where the factories of the tests are.
fn with_factories<'a>(options: &[&'a str]) -> Vec<&'a str> {
    let factories = concat!(env!("CARGO_MANIFEST_DIR"), "/../tests/factories");
    [&["--factories", factories], options].concat()
}

/// A session, its root folder and the schemas of its tools' answers.
pub struct Kit {
    pub session: Session,
    root: TempDir,
    schemas: BTreeMap<String, jsonschema::Validator>,
}

impl Kit {
    pub fn new() -> Self {
        Self::with(&[])
    }

    /// With the factories of the tests and further options.
    pub fn with(options: &[&str]) -> Self {
        Self::over(tempfile::tempdir().unwrap(), options)
    }

    fn over(root: TempDir, options: &[&str]) -> Self {
        let session = Session::spawn(program(), root.path(), &with_factories(options)).unwrap();
        Self::of(root, session)
    }

    /// A server that is started here and logs into a file.
    pub fn logging(root: TempDir, log: &Path, options: &[&str]) -> Self {
        let mut command = std::process::Command::new(program());
        command
            .arg("serve")
            .arg("--root")
            .arg(root.path())
            .args(with_factories(options))
            .env("ASSEMCAD_LOG", "info")
            .stderr(std::fs::File::create(log).unwrap());
        Self::of(root, Session::of(&mut command).unwrap())
    }

    fn of(root: TempDir, session: Session) -> Self {
        let mut session = session.open().unwrap();
        let tools = session.request("tools/list", json!({})).unwrap();
        let schemas = tools["result"]["tools"]
            .as_array()
            .unwrap()
            .iter()
            // A tool that answers with a picture has no schema of its answer.
            .filter_map(|t| {
                let schema = jsonschema::validator_for(t.get("outputSchema")?).unwrap();
                Some((t["name"].as_str().unwrap().to_owned(), schema))
            })
            .collect();
        Self {
            session,
            root,
            schemas,
        }
    }

    /// Kills the server and starts another over the same folder.
    pub fn killed_and_started_again(self) -> Self {
        self.session.kill().unwrap();
        Self::over(self.root, &[])
    }

    /// Ends the server, and gives the folder.
    pub fn closed(self) -> TempDir {
        self.session.close().unwrap();
        self.root
    }

    pub fn root(&self) -> PathBuf {
        self.root.path().to_owned()
    }

    pub fn file(&self, path: &str) -> PathBuf {
        self.root.path().join(path)
    }

    /// Calls a tool that must succeed, with an answer that fits its schema.
    pub fn ok(&mut self, tool: &str, arguments: Value) -> Value {
        let answer = self.session.call(tool, arguments.clone()).unwrap();
        assert!(!answer.is_error, "{tool} {arguments}: {}", answer.content);
        let faults: Vec<String> = self.schemas[tool]
            .iter_errors(&answer.content)
            .map(|e| e.to_string())
            .collect();
        assert!(faults.is_empty(), "{tool}: {faults:?}\n{}", answer.content);
        answer.content
    }

    /// Calls a tool that must be refused, and gives its diagnostics, each of the one shape.
    pub fn refused(&mut self, tool: &str, arguments: Value) -> Vec<Value> {
        let answer = self.session.call(tool, arguments.clone()).unwrap();
        assert!(answer.is_error, "{tool} {arguments}: {}", answer.content);
        // Clients hold refusals against the tool's schema too.
        if let Some(schema) = self.schemas.get(tool) {
            assert!(
                schema.is_valid(&answer.content),
                "{tool}: {}",
                answer.content
            );
        }
        let found = answer.content["diagnostics"].as_array().unwrap().clone();
        assert!(!found.is_empty());
        for d in &found {
            for key in ["code", "severity", "where", "message"] {
                assert!(
                    d[key].as_str().is_some_and(|s| !s.is_empty()),
                    "{key} in {d}"
                );
            }
            let allowed = [
                "code", "severity", "where", "message", "found", "expected", "hint", "next",
            ];
            assert!(
                d.as_object()
                    .unwrap()
                    .keys()
                    .all(|k| allowed.contains(&k.as_str())),
                "{d}"
            );
            assert!(d.to_string().len() < 3000, "{d}");
        }
        found
    }

    /// The one diagnostic of a refused call.
    pub fn refusal(&mut self, tool: &str, arguments: Value) -> Value {
        let mut found = self.refused(tool, arguments);
        assert_eq!(found.len(), 1, "{found:?}");
        found.remove(0)
    }

    pub fn new_assembly(&mut self, assembly: &str) {
        self.ok("new_assembly", json!({"assembly": assembly}));
    }

    pub fn part(&mut self, assembly: &str, part: &str, factory: &str, params: Value) -> Value {
        self.ok(
            "add_part",
            json!({"assembly": assembly, "part": part, "factory": factory, "params": params}),
        )
    }

    pub fn mate(&mut self, call: Value) -> Value {
        self.ok("mate", call)
    }

    /// A block on a plate, a bearing flush in its bore and a shaft through it: four parts. In geometry
    /// all is right; as a machine it is not whole, since one bearing lets the shaft tilt and creep out.
    pub fn stand(&mut self, assembly: &str) {
        self.block_with_bearing(assembly, "coaxial", json!({}));
        self.mate(json!({
            "assembly": assembly, "id": "m3", "mate_type": "coaxial",
            "base": "bearing:inner_ring", "incoming": "shaft:shaft_seat_1",
            "d_mm": -30, "direction": "same", "axioms": ["C-02", "P-01"],
        }));
    }

    /// The stand with a second bearing at the other end of the bore, both pressed in, and the shaft's collar
    /// of 12 mm between them: five parts, and a machine that holds.
    pub fn whole_stand(&mut self, assembly: &str) {
        let segments = [(20, 60), (25, 12), (20, 40)];
        let segments = segments.map(|(d, length)| json!({"d": d, "length": length}));
        self.block_with_bearing(assembly, "press_fit", json!({"segments": segments}));
        // The seat behind the collar, its middle 6 mm before the bearing's front.
        self.mate(json!({
            "assembly": assembly, "id": "m3", "mate_type": "coaxial",
            "base": "bearing:inner_ring", "incoming": "shaft:shaft_seat_3",
            "d_mm": 6, "direction": "same", "axioms": ["C-02", "P-01"],
        }));
        self.part(assembly, "back", "bearing.ball", json!({}));
        self.mate(json!({
            "assembly": assembly, "id": "m4", "mate_type": "press_fit",
            "base": "block:bore_port_back", "incoming": "back:outer_ring",
            "d_mm": -7, "direction": "same", "axioms": ["B-01", "C-03"],
        }));
        self.mate(json!({
            "assembly": assembly, "id": "m5", "mate_type": "coaxial",
            "base": "back:inner_ring", "incoming": "shaft:shaft_seat_1", "axioms": ["C-02", "P-01"],
        }));
        self.intent(
            assembly,
            json!({"intended_motions": [{"part": "shaft", "turns_about": "y"}]}),
        );
    }

    /// States what is meant beside parts and mates.
    pub fn intent(&mut self, assembly: &str, mut stated: Value) {
        stated["assembly"] = json!(assembly);
        self.ok("state_intent", stated);
    }

    fn block_with_bearing(&mut self, assembly: &str, ring: &str, shaft: Value) {
        let fit = if ring == "press_fit" { "C-03" } else { "C-02" };
        self.new_assembly(assembly);
        self.part(assembly, "plate", "base_frame.rect_plate", json!({}));
        self.part(assembly, "block", "base_frame.housing_block", json!({}));
        self.part(assembly, "bearing", "bearing.ball", json!({}));
        self.part(assembly, "shaft", "base_frame.stepped_shaft", shaft);
        self.mate(json!({
            "assembly": assembly, "id": "m1", "mate_type": "face_to_face",
            "base": "plate:top_face", "incoming": "block:bottom_face", "axioms": ["C-01"],
            "bond": "welded",
        }));
        self.mate(json!({
            "assembly": assembly, "id": "m2", "mate_type": ring,
            "base": "block:bore_port", "incoming": "bearing:outer_ring",
            "d_mm": -7, "direction": "same", "axioms": ["B-01", fit],
        }));
    }

    /// Every file below the root with its bytes, locks and caches left out.
    pub fn files(&self) -> BTreeMap<String, Vec<u8>> {
        let mut found = BTreeMap::new();
        collect(self.root.path(), self.root.path(), &mut found);
        found
    }
}

fn collect(top: &Path, folder: &Path, found: &mut BTreeMap<String, Vec<u8>>) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let name = path.strip_prefix(top).unwrap().to_str().unwrap().to_owned();
        if name == ".assemcad" {
            continue;
        }
        if path.is_dir() {
            collect(top, &path, found);
        } else {
            found.insert(name, std::fs::read(&path).unwrap());
        }
    }
}

/// The codes of diagnostics, in order.
pub fn codes(found: &[Value]) -> Vec<&str> {
    found.iter().map(|d| d["code"].as_str().unwrap()).collect()
}

/// Whether a value is a number near another.
pub fn near(value: &Value, wanted: f64, tolerance: f64) -> bool {
    value
        .as_f64()
        .is_some_and(|v| (v - wanted).abs() <= tolerance)
}
