//! From a text to as much of a specification as can be told from it.

use std::sync::LazyLock;

use assemcad_model::diagnostic::{Code, Diagnostic, Severity};
use assemcad_model::name::nearest;
use assemcad_model::param::clip;
use assemcad_model::spec::tree::{PartNode, Tree};
use assemcad_model::spec::{Assembly, Document, Mate, Part, schema};
use assemcad_model::told::Capped;
use assemcad_model::yaml::{self, Kind, Node, Step};
use jsonschema::error::ValidationErrorKind as Fault;
use jsonschema::{ValidationError, Validator};
use serde_json::{Value, json};

/// The two forms in which a specification may be written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Form {
    /// `assembly: {parts: [...], mates: [...]}`.
    Document,
    /// `parts_index: {NAME: ...}, mates: [...]`.
    Tree,
}

/// What was read of a draft.
#[derive(Debug)]
pub struct Draft {
    /// The draft's name, where it has one.
    pub id: Option<String>,
    /// The specification; none where its form is at fault.
    pub assembly: Option<Assembly>,
    /// Its parts one by one, in order; what cannot be read of one is left out.
    pub parts: Vec<Loose<Part>>,
    /// Its mates one by one.
    pub mates: Vec<Loose<Mate>>,
    /// The name of the root, where one is given.
    pub root: Option<String>,
    /// What is wrong with the text and its form.
    pub faults: Vec<Diagnostic>,
    node: Option<Node>,
    form: Form,
}

/// Something of which at least the names may be readable.
#[derive(Debug)]
pub struct Loose<T> {
    /// Its name, where it has one.
    pub id: Option<String>,
    /// The names of the parts that it joins, for a mate.
    pub joins: Vec<String>,
    /// The thing; none where its form is at fault.
    pub whole: Option<T>,
}

struct Schema {
    value: Value,
    validator: Option<Validator>,
}

impl Schema {
    fn new(value: Value) -> Self {
        Self {
            validator: jsonschema::validator_for(&value).ok(),
            value,
        }
    }
}

static DOCUMENT: LazyLock<Schema> = LazyLock::new(|| Schema::new(schema::document()));
static TREE: LazyLock<Schema> = LazyLock::new(|| Schema::new(schema::tree()));

impl Draft {
    /// Reads a text in either form.
    #[must_use]
    pub fn read(text: &str) -> Self {
        let yaml::Read { node, mut faults } = yaml::read(text);
        let form = match &node {
            Some(n) if n.get("assembly").is_none() && n.get("parts_index").is_some() => Form::Tree,
            _ => Form::Document,
        };
        let mut draft = Self {
            id: None,
            assembly: None,
            parts: Vec::new(),
            mates: Vec::new(),
            root: None,
            faults: Vec::new(),
            node,
            form,
        };
        let schema = form.schema();
        if let Some(value) = draft.node.as_ref().map(|n| n.value(Some(&schema.value))) {
            draft.take(&value);
            match &schema.validator {
                Some(validator) => {
                    let mut found = Capped::new();
                    for e in validator.iter_errors(&value) {
                        draft.form_faults(&e, &schema.value, &mut found);
                    }
                    faults.extend(found.told());
                }
                None => faults.push(Diagnostic::error(
                    Code::Internal,
                    "schema",
                    "the specification's own schema is at fault",
                )),
            }
            let errors = faults.iter().any(|d| d.severity == Severity::Error);
            if !errors {
                match form.assembly(value) {
                    Ok(assembly) => draft.assembly = Some(assembly.normal()),
                    // The schema is made from the types, so this is not met.
                    Err(e) => faults.push(Diagnostic::error(
                        Code::SpecificationInvalid,
                        "line 1",
                        format!("it fits the schema and yet cannot be read: {e}"),
                    )),
                }
            }
        }
        draft.faults = faults;
        draft
    }

    /// A place in the specification (`mates[0].base`) as it is told: with its line, and as it is written.
    #[must_use]
    pub fn place(&self, path: &str) -> String {
        let mut steps = steps(path);
        let mut shown = path.to_owned();
        if self.form == Form::Tree
            && let [Step::Key(first), Step::Index(i), rest @ ..] = steps.as_slice()
            && first == "parts"
        {
            let name = match self.parts.get(*i) {
                Some(Loose { id: Some(id), .. }) => id.clone(),
                _ => i.to_string(),
            };
            let behind = path.split_once(']').map_or("", |(_, rest)| rest);
            shown = format!("parts_index.{name}{behind}");
            let mut there = vec![Step::Key("parts_index".to_owned()), Step::Index(*i)];
            there.extend_from_slice(rest);
            steps = there;
        }
        // Fields beside `assembly` (the format) are told by their names alone, like those within it.
        let outside = match (&self.node, steps.first()) {
            (Some(n), Some(Step::Key(k))) => {
                n.get(k).is_some() && n.get("assembly").is_none_or(|a| a.get(k).is_none())
            }
            _ => false,
        };
        if self.form == Form::Document && !outside {
            steps.insert(0, Step::Key("assembly".to_owned()));
        }
        let line = self.node.as_ref().map_or(1, |n| n.line_of(&steps));
        if shown.is_empty() {
            return format!("line {line}");
        }
        format!("line {line}, {}", clip(&shown))
    }

    /// The parts and mates one by one, so that a fault in one does not hide those of the others.
    fn take(&mut self, value: &Value) {
        let inner = match self.form {
            Form::Document => value.get("assembly").unwrap_or(&Value::Null),
            Form::Tree => value,
        };
        let text = |v: &Value, key: &str| v.get(key).and_then(Value::as_str).map(str::to_owned);
        self.id = text(inner, "id");
        self.root = text(inner, "root");
        let no_part = |id, whole| Loose {
            id,
            joins: Vec::new(),
            whole,
        };
        self.parts = match (self.form, inner.get("parts"), inner.get("parts_index")) {
            (Form::Document, Some(Value::Array(items)), _) => items
                .iter()
                .map(|v| no_part(text(v, "id"), serde_json::from_value(v.clone()).ok()))
                .collect(),
            (Form::Tree, _, Some(Value::Object(nodes))) => nodes
                .iter()
                .map(|(id, v)| {
                    let node: Option<PartNode> = serde_json::from_value(v.clone()).ok();
                    let whole = node.map(|n| Part {
                        id: id.clone(),
                        factory: n.factory,
                        params: n.params,
                        elastic: n.elastic,
                        notes: n.notes,
                    });
                    no_part(Some(id.clone()), whole)
                })
                .collect(),
            _ => Vec::new(),
        };
        let mates = inner.get("mates").and_then(Value::as_array);
        self.mates = mates
            .into_iter()
            .flatten()
            .map(|v| Loose {
                id: text(v, "id"),
                joins: ["base", "incoming"]
                    .iter()
                    .filter_map(|end| text(v.get(*end)?, "ref"))
                    .collect(),
                whole: serde_json::from_value(v.clone()).ok(),
            })
            .collect();
    }

    /// What one finding of the schema means.
    fn form_faults(&self, e: &ValidationError<'_>, schema: &Value, found: &mut Capped) {
        if let Fault::AdditionalProperties { unexpected } = e.kind() {
            let pointer = e.instance_path().as_str();
            let path = self.path(pointer);
            let known = fields(within(schema, pointer));
            for name in unexpected {
                found.push(|| self.unknown_field(&path, name, &known));
            }
        } else {
            found.push(|| self.form_fault(e, schema));
        }
    }

    fn unknown_field(&self, path: &str, name: &str, known: &[String]) -> Diagnostic {
        let d = Diagnostic::error(
            Code::SpecificationInvalid,
            self.place(&join(path, name)),
            format!("there is no field '{}' here", clip(name)),
        )
        .expected(json!(known));
        match nearest(name, known.iter().map(String::as_str), 1).first() {
            Some(near) => d.hint(format!("did you mean '{near}'?")),
            None => d,
        }
    }

    /// What a finding of the schema means that is one fault.
    fn form_fault(&self, e: &ValidationError<'_>, schema: &Value) -> Diagnostic {
        let pointer = e.instance_path().as_str();
        let path = self.path(pointer);
        let at = |path: &str| self.place(path);
        let wrong = |path: &str, message: String| {
            Diagnostic::error(Code::SpecificationInvalid, at(path), message)
        };
        let here = within(schema, pointer);
        match e.kind() {
            Fault::Required { property } => {
                let name = property.as_str().unwrap_or_default();
                let d = wrong(&join(&path, name), format!("'{name}' is missing"));
                let meaning = here
                    .and_then(|s| s.get("properties")?.get(name)?.get("description"))
                    .cloned();
                match meaning {
                    Some(meaning) => d.expected(meaning),
                    None => d,
                }
            }
            Fault::Type { .. } => {
                let kind = here.and_then(|s| s.get("type")).and_then(Value::as_str);
                let wanted = match kind {
                    Some("object") => "fields",
                    Some("array") => "a list",
                    Some("integer") => "a whole number",
                    _ => "a text",
                };
                let d =
                    wrong(&path, format!("expected {wanted}")).found(e.instance().as_ref().clone());
                let known = fields(here);
                if known.is_empty() {
                    d
                } else {
                    d.expected(json!(known))
                }
            }
            Fault::Enum { options } => {
                let found = e.instance().as_ref();
                let words: Vec<&str> = options
                    .as_array()
                    .map(|all| all.iter().filter_map(Value::as_str).collect())
                    .unwrap_or_default();
                let word = found.as_str().unwrap_or_default();
                let d = wrong(&path, format!("there is no '{}' here", clip(word)))
                    .found(found.clone())
                    .expected(json!(words));
                match nearest(word, words.iter().copied(), 1).first() {
                    Some(near) => d.hint(format!("did you mean '{near}'?")),
                    None => d,
                }
            }
            _ => {
                let d = wrong(&path, "this does not fit the format".to_owned());
                d.found(e.instance().as_ref().clone()).expected(json!(here))
            }
        }
    }

    /// A JSON pointer as a path into the assembly: `/assembly/mates/0/base` as `mates[0].base`.
    fn path(&self, pointer: &str) -> String {
        let mut path = String::new();
        // In the tree form, parts are counted like everywhere else, and named when they are told.
        let mut counted = self.form == Form::Tree && pointer.starts_with("/parts_index/");
        let pointer = match self.form {
            Form::Document => pointer.strip_prefix("/assembly").unwrap_or(pointer),
            Form::Tree => pointer,
        };
        for (depth, step) in pointer.split('/').skip(1).enumerate() {
            let step = step.replace("~1", "/").replace("~0", "~");
            if counted && depth == 0 {
                path.push_str("parts");
            } else if counted && depth == 1 {
                counted = false;
                let parts = self.node.as_ref().and_then(|n| n.get("parts_index"));
                let i = match parts.map(|n| &n.kind) {
                    Some(Kind::Map(entries)) => entries.position(&step),
                    _ => None,
                };
                path.push_str(&format!("[{}]", i.unwrap_or_default()));
            } else if step.bytes().all(|b| b.is_ascii_digit()) {
                path.push_str(&format!("[{step}]"));
            } else {
                path = join(&path, &step);
            }
        }
        path
    }
}

impl Form {
    fn schema(self) -> &'static Schema {
        match self {
            Self::Document => &DOCUMENT,
            Self::Tree => &TREE,
        }
    }

    fn assembly(self, value: Value) -> Result<Assembly, serde_json::Error> {
        match self {
            Self::Document => serde_json::from_value::<Document>(value).map(|d| d.assembly),
            Self::Tree => serde_json::from_value::<Tree>(value).map(Assembly::from),
        }
    }
}

fn join(path: &str, name: &str) -> String {
    if path.is_empty() {
        name.to_owned()
    } else {
        format!("{path}.{name}")
    }
}

/// The names of the fields that a schema has.
fn fields(schema: Option<&Value>) -> Vec<String> {
    let map = schema
        .and_then(|s| s.get("properties"))
        .and_then(Value::as_object);
    map.into_iter().flat_map(|m| m.keys().cloned()).collect()
}

/// The schema of the place that a JSON pointer leads to.
fn within<'a>(schema: &'a Value, pointer: &str) -> Option<&'a Value> {
    let mut here = schema;
    for step in pointer.split('/').skip(1) {
        here = here
            .get("properties")
            .and_then(|p| p.get(step))
            .or_else(|| here.get("items"))
            .or_else(|| here.get("additionalProperties"))?;
    }
    Some(here)
}

/// The steps of a path such as `mates[0].base.port`.
fn steps(path: &str) -> Vec<Step> {
    let mut steps = Vec::new();
    for word in path.split('.').filter(|w| !w.is_empty()) {
        let mut pieces = word.split('[');
        if let Some(name) = pieces.next().filter(|n| !n.is_empty()) {
            steps.push(Step::Key(name.to_owned()));
        }
        for piece in pieces {
            if let Ok(i) = piece.trim_end_matches(']').parse() {
                steps.push(Step::Index(i));
            }
        }
    }
    steps
}
