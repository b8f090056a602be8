//! The assemblies on disk: one folder each, below the root and nowhere else.
//!
//! `assemblies/NAME/assembly.yaml` is the specification; beside it lie the report and the STEP file.

use std::io;

use assemcad_model::diagnostic::{Code, Diagnostic, Severity};
use assemcad_model::name::{self, nearest};
use assemcad_model::param::clip;
use assemcad_model::spec::{Assembly, text};
use assemcad_model::yaml::MOST_BYTES;
use serde_json::json;

use crate::draft::Draft;
use crate::fault::file_failed;
use crate::files::check_path;
use crate::root::{ASSEMBLIES, Lock, Store, flock};

/// Where files go that were asked for by name.
const EXPORTS: &str = "exports";

const SPECIFICATION: &str = "assembly.yaml";

impl Store {
    /// The names of the assemblies, sorted.
    ///
    /// # Errors
    /// When the folder cannot be read.
    pub fn names(&self) -> Result<Vec<String>, Diagnostic> {
        let list = || -> io::Result<Vec<String>> {
            let mut names = Vec::new();
            for entry in self.root.read_dir(ASSEMBLIES)? {
                if let Ok(name) = entry?.file_name().into_string()
                    && name::is_valid(&name)
                    && self.root.exists(specification(&name))
                {
                    names.push(name);
                }
            }
            names.sort();
            Ok(names)
        };
        list().map_err(|e| file_failed(ASSEMBLIES, "listed", &e))
    }

    /// Waits until no other writer holds the assembly, and holds it.
    ///
    /// # Errors
    /// When there is no assembly of this name.
    pub async fn lock(&self, id: &str) -> Result<Lock, Diagnostic> {
        check_name("assembly", id)?;
        // Opened as a file: the handle of a folder opened as a capability cannot be locked.
        let folder = match self.root.open(format!("{ASSEMBLIES}/{id}")) {
            Ok(folder) => folder.into_std(),
            Err(e) if e.kind() == io::ErrorKind::NotFound => return Err(self.unknown(id)),
            Err(e) => return Err(file_failed(id, "locked", &e)),
        };
        let lock = flock(folder, id).await?;
        // Whoever held it before may have died in the middle of a change.
        self.mend();
        Ok(lock)
    }

    /// Makes the folder of an assembly, so that it can be locked. An empty folder is no assembly.
    ///
    /// # Errors
    /// When the name is none or the folder cannot be made.
    pub fn make_folder(&self, id: &str) -> Result<(), Diagnostic> {
        check_name("assembly", id)?;
        let folder = format!("{ASSEMBLIES}/{id}");
        self.root
            .create_dir_all(&folder)
            .map_err(|e| file_failed(&folder, "made", &e))
    }

    /// Reads a specification.
    ///
    /// # Errors
    /// When there is no assembly of this name (the valid names are in the diagnostic), or the file
    /// is not a specification.
    pub fn load(&self, id: &str) -> Result<Assembly, Diagnostic> {
        check_name("assembly", id)?;
        let bytes = match self.root.read(specification(id)) {
            Ok(bytes) => bytes,
            Err(e) if e.kind() == io::ErrorKind::NotFound => return Err(self.unknown(id)),
            Err(e) => return Err(file_failed(&specification(id), "read", &e)),
        };
        let damaged = |why: String| {
            Diagnostic::error(
                Code::FileDamaged,
                specification(id),
                format!("the stored specification is not readable: {why}"),
            )
            .hint("restore the file from a copy, or make the assembly anew under another name")
        };
        let text = String::from_utf8(bytes).map_err(|_| damaged("it is no text".to_owned()))?;
        let draft = Draft::read(&text);
        let Some(assembly) = draft.assembly else {
            let why = draft.faults.iter().find(|d| d.severity == Severity::Error);
            return Err(damaged(why.map_or_else(String::new, ToString::to_string)));
        };
        if assembly.id != id {
            return Err(damaged(format!("it is that of '{}'", clip(&assembly.id))));
        }
        Ok(assembly)
    }

    /// What is lost when a stored specification is written again: comments that people put into it.
    #[must_use]
    pub fn lost_by_writing(&self, id: &str) -> Vec<Diagnostic> {
        let bytes = self.root.read(specification(id)).unwrap_or_default();
        let faults = String::from_utf8(bytes).map(|text| Draft::read(&text).faults);
        faults
            .unwrap_or_default()
            .into_iter()
            .filter(|d| d.code == Code::CommentLost)
            .map(|d| {
                let place = format!("{}, {}", specification(id), d.place);
                d.at(place)
            })
            .collect()
    }

    /// Whether an assembly of this name exists.
    #[must_use]
    pub fn exists(&self, id: &str) -> bool {
        name::is_valid(id) && self.root.exists(specification(id))
    }

    /// Writes a specification; it is on disk when this returns.
    ///
    /// # Errors
    /// When it cannot be written; what was there before is then untouched.
    pub fn save(&self, assembly: &Assembly) -> Result<(), Diagnostic> {
        self.write(&specification(&assembly.id), &yaml_bytes(assembly)?)
    }

    fn unknown(&self, id: &str) -> Diagnostic {
        let names = self.names().unwrap_or_default();
        let near = nearest(id, names.iter().map(String::as_str), 1)
            .first()
            .map(|n| (*n).to_owned());
        let d = Diagnostic::error(
            Code::AssemblyUnknown,
            "assembly",
            format!("there is no assembly '{}'", clip(id)),
        )
        .found(id)
        .expected(json!(names));
        match near {
            Some(near) => d.hint(format!("did you mean '{near}'?")),
            None => d.next("new_assembly", json!({"assembly": id})),
        }
    }
}

/// The stored form of an assembly. It is read back before it is given out: what is on disk is what was meant.
///
/// # Errors
/// When the name is none, or the text is too long to be read again.
pub fn yaml_bytes(assembly: &Assembly) -> Result<Vec<u8>, Diagnostic> {
    check_name("assembly", &assembly.id)?;
    let wrong = |why: String| Diagnostic::error(Code::Internal, &assembly.id, why);
    let text = text::write(assembly).map_err(|e| wrong(e.to_string()))?;
    if text.len() > MOST_BYTES {
        return Err(Diagnostic::error(
            Code::FileFailed,
            "assembly",
            format!("the specification would be longer than {MOST_BYTES} bytes"),
        ));
    }
    if Draft::read(&text).assembly != Some(assembly.clone().normal()) {
        return Err(wrong(
            "the specification does not read back as what it is".to_owned(),
        ));
    }
    Ok(text.into_bytes())
}

/// The path of an assembly's file, below the root.
#[must_use]
pub fn file_of(id: &str, name: &str) -> String {
    format!("{ASSEMBLIES}/{id}/{name}")
}

/// The path of a file that was asked for by name, below the root: in a place of the assembly's own, where it takes
/// the place of nothing but an earlier export of the same assembly.
///
/// # Errors
/// When the name leads out of that place.
pub fn export_of(id: &str, file: &str) -> Result<String, Diagnostic> {
    check_path(file)?;
    let place = format!("{EXPORTS}/{id}/");
    Ok(if file.starts_with(&place) {
        file.to_owned()
    } else {
        format!("{place}{file}")
    })
}

/// The path of an assembly's specification, below the root.
#[must_use]
pub fn specification(id: &str) -> String {
    file_of(id, SPECIFICATION)
}

/// Checks a name that a client chose.
///
/// # Errors
/// When it breaks the rule for names.
pub fn check_name(place: &str, name: &str) -> Result<(), Diagnostic> {
    if name::is_valid(name) {
        return Ok(());
    }
    Err(
        Diagnostic::error(Code::NameInvalid, place, "this is not a name".to_owned())
            .found(name)
            .expected(name::RULE),
    )
}

#[cfg(test)]
mod tests {
    use super::Store;
    use assemcad_model::diagnostic::Code;
    use assemcad_model::spec::Assembly;

    fn code<T: std::fmt::Debug>(r: Result<T, assemcad_model::diagnostic::Diagnostic>) -> Code {
        r.unwrap_err().code
    }

    #[test]
    fn what_is_saved_is_there_for_the_next_one() {
        let root = tempfile::tempdir().unwrap();
        let stand = Assembly::new("stand", "a stand");
        Store::open(root.path()).unwrap().save(&stand).unwrap();
        let again = Store::open(root.path()).unwrap();
        assert_eq!(again.load("stand").unwrap(), stand);
        assert_eq!(again.names().unwrap(), ["stand"]);
        let d = again.load("stnad").unwrap_err();
        assert_eq!(d.expected.unwrap(), serde_json::json!(["stand"]));
    }

    #[test]
    fn a_damaged_specification_is_told_and_left_alone() {
        let root = tempfile::tempdir().unwrap();
        let store = Store::open(root.path()).unwrap();
        store.save(&Assembly::new("a", "")).unwrap();
        let path = root.path().join("assemblies/a/assembly.yaml");
        for bad in [
            "",
            "{",
            r#"{"format":2,"assembly":{"id":"a"}}"#,
            r#"{"format":1,"assembly":{"id":"b"}}"#,
        ] {
            std::fs::write(&path, bad).unwrap();
            assert_eq!(code(store.load("a")), Code::FileDamaged, "{bad}");
            assert_eq!(std::fs::read_to_string(&path).unwrap(), bad);
        }
    }

    #[test]
    fn exports_have_a_place_of_their_own() {
        let of = |file: &str| super::export_of("a", file);
        assert_eq!(of("x/y.step").unwrap(), "exports/a/x/y.step");
        // As an earlier answer named it.
        assert_eq!(of("exports/a/x.step").unwrap(), "exports/a/x.step");
        assert_eq!(
            of("exports/b/x.step").unwrap(),
            "exports/a/exports/b/x.step"
        );
        assert_eq!(
            of("assemblies/b/b.step").unwrap(),
            "exports/a/assemblies/b/b.step"
        );
        for bad in ["", "/x.step", "../x.step", "x/../../y.step"] {
            assert_eq!(code(of(bad)), Code::PathInvalid, "{bad}");
        }
    }

    #[tokio::test]
    async fn two_writers_take_turns() {
        let root = tempfile::tempdir().unwrap();
        let store = Store::open(root.path()).unwrap();
        assert_eq!(code(store.lock("a").await), Code::AssemblyUnknown);
        store.make_folder("a").unwrap();
        let held = store.lock("a").await.unwrap();
        let wait = std::time::Duration::from_millis(50);
        assert!(tokio::time::timeout(wait, store.lock("a")).await.is_err());
        drop(held);
        store.lock("a").await.unwrap();
    }
}
