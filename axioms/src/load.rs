//! From the text of the data files to axioms, with the line of everything that is wrong.

use assemcad_model::diagnostic::Severity;
use assemcad_model::yaml::{self, Kind, Node, Step};
use serde::Serialize;
use serde_json::Value;

use crate::axiom::{Axiom, Category, Checking, Force, Provenance};
use crate::entry::{CheckKind, Entry, ProvenanceKind, file_schema};
use crate::validate;

/// Something that is wrong with the data.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord, Serialize)]
pub struct DataFault {
    /// The file.
    pub file: String,
    /// The line, counted from 1.
    pub line: usize,
    /// What is wrong.
    pub message: String,
}

impl core::fmt::Display for DataFault {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        write!(f, "{}:{}: {}", self.file, self.line, self.message)
    }
}

/// An axiom with its place in the data.
#[derive(Debug, Clone)]
pub(crate) struct Located {
    pub(crate) axiom: Axiom,
    pub(crate) file: String,
    pub(crate) node: Node,
}

impl Located {
    /// A fault at one of the axiom's fields.
    pub(crate) fn fault(&self, field: &str, message: String) -> DataFault {
        DataFault {
            file: self.file.clone(),
            line: self.node.line_of(&[Step::Key(field.to_owned())]),
            message: format!("{}: {message}", self.axiom.id),
        }
    }
}

/// Reads files, given as name and text, and validates them together. The axioms come sorted by their ids.
///
/// # Errors
/// Everything that is wrong, sorted by file and line.
pub fn load(files: &[(&str, &str)]) -> Result<Vec<Axiom>, Vec<DataFault>> {
    let mut faults = Vec::new();
    let mut all = Vec::new();
    for (name, text) in files {
        all.extend(file(name, text, &mut faults));
    }
    // What could not be read would show up again as an id that does not exist.
    if faults.is_empty() {
        faults = validate::all(&all);
    }
    if !faults.is_empty() {
        faults.sort();
        return Err(faults);
    }
    let mut axioms: Vec<Axiom> = all.into_iter().map(|l| l.axiom).collect();
    axioms.sort_by(|a, b| a.id.cmp(&b.id));
    Ok(axioms)
}

fn file(name: &str, text: &str, faults: &mut Vec<DataFault>) -> Vec<Located> {
    let fault = |line: usize, message: String| DataFault {
        file: name.to_owned(),
        line,
        message,
    };
    let read = yaml::read(text);
    for d in read.faults {
        // Comments are welcome here: these files are not written back.
        if d.severity == Severity::Error {
            let line = d.place.rsplit(' ').next().and_then(|n| n.parse().ok());
            faults.push(fault(line.unwrap_or(1), d.message));
        }
    }
    let Some(root) = read.node else {
        return Vec::new();
    };
    let schema = file_schema();
    let mut out = Vec::new();
    let category = root.get("category").map(|n| n.value(None));
    let category = match category.map(serde_json::from_value::<Category>) {
        Some(Ok(category)) => category,
        Some(Err(e)) => {
            let line = root.line_of(&[Step::Key("category".to_owned())]);
            faults.push(fault(line, e.to_string()));
            return out;
        }
        None => {
            faults.push(fault(root.line, "'category' is missing".to_owned()));
            return out;
        }
    };
    if let Kind::Map(entries) = &root.kind {
        for (key, _) in entries {
            if key.name != "category" && key.name != "axioms" {
                faults.push(fault(key.line, format!("unknown field '{}'", key.name)));
            }
        }
    }
    let Some(Node {
        kind: Kind::List(items),
        ..
    }) = root.get("axioms")
    else {
        faults.push(fault(root.line, "'axioms' is no list".to_owned()));
        return out;
    };
    let inner = schema.pointer("/properties/axioms/items");
    for item in items {
        match entry(item, inner, category) {
            Ok(axiom) => out.push(Located {
                axiom,
                file: name.to_owned(),
                node: item.clone(),
            }),
            Err((line, message)) => faults.push(fault(line, message)),
        }
    }
    out
}

fn entry(
    node: &Node,
    schema: Option<&Value>,
    category: Category,
) -> Result<Axiom, (usize, String)> {
    let value = node.value(schema);
    let id = value
        .get("id")
        .and_then(Value::as_str)
        .unwrap_or("an axiom without an id")
        .to_owned();
    let e: Entry = serde_json::from_value(value)
        .map_err(|e| (line_of_error(node, &e.to_string()), format!("{id}: {e}")))?;
    let at = |field: &str| node.line_of(&[Step::Key(field.to_owned())]);
    let force = Force::of(&e.statement).ok_or_else(|| {
        let message = format!("{id}: a statement has one of MUST, MUST NOT and SHOULD, once");
        (at("statement"), message)
    })?;
    let p = e.provenance;
    let provenance = match (p.kind, p.source, p.topic, p.clause, p.justification) {
        (ProvenanceKind::Anchored, Some(source), Some(topic), clause, None) => {
            Provenance::Anchored {
                source,
                topic,
                clause,
            }
        }
        (ProvenanceKind::Synthesized, None, None, None, Some(justification)) => {
            Provenance::Synthesized { justification }
        }
        _ => {
            let message = format!(
                "{id}: anchored takes 'source', 'topic' and maybe 'clause'; synthesized takes 'justification'"
            );
            return Err((at("provenance"), message));
        }
    };
    let c = e.check;
    let check = match (c.kind, c.id, c.why) {
        (CheckKind::Checked, Some(id), None) if !c.needs.is_empty() => {
            Checking::Checked { id, needs: c.needs }
        }
        (CheckKind::None, None, Some(why)) if c.needs.is_empty() => Checking::None { why },
        _ => {
            let message = format!("{id}: checked takes 'id' and 'needs'; none takes 'why'");
            return Err((at("check"), message));
        }
    };
    Ok(Axiom {
        id: e.id,
        category,
        title: e.title,
        statement: e.statement,
        force,
        decision: e.decision,
        scope: e.scope,
        rationale: e.rationale,
        provenance,
        precedes: e.precedes,
        follows: e.follows,
        check,
    })
}

/// The line of the word that serde quotes between backticks, or of the entry.
fn line_of_error(node: &Node, message: &str) -> usize {
    fn find(node: &Node, word: &str) -> Option<usize> {
        match &node.kind {
            Kind::Scalar { text, .. } => (text == word).then_some(node.line),
            Kind::List(items) => items.iter().find_map(|n| find(n, word)),
            Kind::Map(entries) => entries.iter().find_map(|(k, n)| {
                if k.name == word {
                    Some(k.line)
                } else {
                    find(n, word)
                }
            }),
        }
    }
    message
        .split('`')
        .nth(1)
        .and_then(|word| find(node, word))
        .unwrap_or(node.line)
}
