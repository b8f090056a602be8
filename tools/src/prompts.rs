//! The prompts: Markdown with placeholders, filled from the code when they are asked for.

use core::fmt::Write as _;

use assemcad_assembly::Workshop;
use assemcad_axioms::{Axiom, axioms};
use assemcad_factories::Registry;
use assemcad_model::diagnostic::{Code, Diagnostic};
use assemcad_model::mates;
use assemcad_model::param::{ParamKind, ParamSpec};
use assemcad_model::ports;
use assemcad_model::yaml::flow;
use serde_json::{Map, Value};

/// A prompt.
#[derive(Debug)]
pub struct Prompt {
    /// Name.
    pub name: &'static str,
    /// For people: a few words.
    pub title: &'static str,
    /// What it is for.
    pub description: &'static str,
    /// What it wants to know; all of it is required.
    pub arguments: &'static [Argument],
    template: &'static str,
}

/// An argument of a prompt; a text.
#[derive(Debug)]
pub struct Argument {
    /// Name.
    pub name: &'static str,
    /// What it means.
    pub description: &'static str,
}

/// Every prompt, sorted by name.
pub static ALL: [Prompt; 3] = [
    Prompt {
        name: "decompose",
        title: "Design an assembly",
        description: "Turns a description in words into a valid assembly specification: the format, the \
                      factories, ports and mates there are, the way of working and frequent mistakes.",
        arguments: &[Argument {
            name: "description",
            description: "What is to be built, in plain words: function, sizes, loads, what is given.",
        }],
        template: include_str!("../../prompts/decompose.md"),
    },
    Prompt {
        name: "repair",
        title: "Mend a factory",
        description: "Mends a factory's source that synthesize_factory refused: how to read the findings, \
                      and the language on one page.",
        arguments: &[
            Argument {
                name: "source",
                description: "The source that was refused.",
            },
            Argument {
                name: "findings",
                description: "The findings of the answer, as they are.",
            },
        ],
        template: include_str!("../../prompts/repair.md"),
    },
    Prompt {
        name: "synthesize",
        title: "Write a factory",
        description: "Writes a factory for a part that no factory makes: the way of working, what is held \
                      against the source, the language on one page and frequent mistakes.",
        arguments: &[Argument {
            name: "description",
            description: "The part, in plain words: function, form, sizes, what is mated to it.",
        }],
        template: include_str!("../../prompts/synthesize.md"),
    },
];

/// The longest description that is taken, in characters.
const MOST_DESCRIPTION: usize = 20_000;

impl Prompt {
    /// The text, with what the server knows and what the caller wants filled in.
    ///
    /// # Errors
    /// When an argument is missing, no text, unknown or too long.
    pub async fn text(
        &self,
        workshop: &Workshop,
        given: &Map<String, Value>,
    ) -> Result<String, Diagnostic> {
        let known = |name: &str| self.arguments.iter().any(|a| a.name == name);
        if let Some((name, _)) = given.iter().find(|(name, _)| !known(name)) {
            let name = assemcad_model::param::clip(name);
            let message = format!("there is no argument '{name}'");
            return Err(Diagnostic::error(Code::ArgumentInvalid, name, message));
        }
        let mut text = self
            .template
            .replace("{{PORTS}}", &port_types())
            .replace("{{MATES}}", &mate_types())
            .replace("{{AXIOMS}}", &axioms_by_mate_type())
            .replace("{{LANGUAGE}}", assemcad_script::reference().trim())
            .replace("{{ROUNDS}}", &workshop.draft_rounds.to_string())
            .replace(
                "{{SYNTHESIS_ROUNDS}}",
                &workshop.synthesis_rounds.to_string(),
            );
        if text.contains("{{FACTORIES}}") {
            text = text.replace("{{FACTORIES}}", &factories(workshop).await);
        }
        // Last, and each once: what a caller writes is no template.
        for argument in self.arguments {
            let value = match given.get(argument.name) {
                Some(Value::String(s)) if s.chars().count() <= MOST_DESCRIPTION => s.trim(),
                _ => {
                    return Err(Diagnostic::error(
                        Code::ArgumentInvalid,
                        argument.name,
                        format!("expected a text of at most {MOST_DESCRIPTION} characters"),
                    ));
                }
            };
            let place = format!("{{{{{}}}}}", argument.name.to_uppercase());
            text = text.replacen(&place, value, 1);
        }
        Ok(text)
    }
}

/// The factories by family, each with its parameters and, of ours, the ports that it has at their
/// defaults.
async fn factories(workshop: &Workshop) -> String {
    let mut out = String::new();
    let mut family = "";
    for factory in &workshop.registry.all() {
        let name = factory.name();
        let space = name.split_once('.').map_or(name, |(space, _)| space);
        if space != family {
            if !family.is_empty() {
                out.push('\n');
            }
            family = space;
            // Writing to a text cannot fail.
            let _ = write!(out, "**{space}**");
        }
        let params: Vec<String> = factory.params().iter().map(parameter).collect();
        let _ = write!(out, "\n- `{name}({})`", params.join(", "));
        if !Registry::is_builtin(name) {
            out.push_str(": ports by describe_factory");
        } else if let Ok(made) = workshop.make(name, &Map::new(), None).await {
            let _ = write!(out, ": {}", ports_of(&made.ports));
        }
    }
    out
}

fn parameter(p: &ParamSpec) -> String {
    match &p.kind {
        ParamKind::Choice { choices, .. } => format!("{}={}", p.name, choices.join("|")),
        ParamKind::Records { fields, .. } => {
            let fields: Vec<&str> = fields.iter().map(|f| f.name.as_str()).collect();
            format!("{}=[{{{}}}]", p.name, fields.join(", "))
        }
        _ => format!("{}={}", p.name, flow(&short(p.default_value()))),
    }
}

/// A whole number without its `.0`.
fn short(value: Value) -> Value {
    match value.as_f64() {
        Some(v) if v.fract() == 0.0 && v.abs() < 1e15 => (v as i64).into(),
        _ => value,
    }
}

/// Ports grouped by their types.
fn ports_of(all: &[ports::Port]) -> String {
    let mut groups: Vec<(ports::PortType, Vec<&str>)> = Vec::new();
    for port in all {
        match groups.iter_mut().find(|(t, _)| *t == port.port_type) {
            Some((_, names)) => names.push(&port.name),
            None => groups.push((port.port_type, vec![&port.name])),
        }
    }
    let groups: Vec<String> = groups
        .iter()
        .map(|(t, names)| format!("{} {t}", names.join(", ")))
        .collect();
    groups.join("; ")
}

fn port_types() -> String {
    let line = |kind: &&ports::PortKind| format!("- `{}`: {}", kind.name, kind.summary());
    ports::ALL.iter().map(line).collect::<Vec<_>>().join("\n")
}

fn mate_types() -> String {
    let line = |kind: &&mates::MateKind| {
        let options: Vec<String> = (kind.options)().iter().map(option).collect();
        let pairs: Vec<String> = kind.pairs.iter().map(|(b, i)| format!("{b}-{i}")).collect();
        format!(
            "- `{}({})`: {} Joins {}.",
            kind.name,
            options.join(", "),
            kind.doc,
            pairs.join(", ")
        )
    };
    mates::ALL.iter().map(line).collect::<Vec<_>>().join("\n")
}

fn option(p: &ParamSpec) -> String {
    match &p.kind {
        ParamKind::Choice { choices, .. } => format!("{}={}", p.name, choices.join("|")),
        _ => p.name.clone(),
    }
}

/// Ids and titles by mate type, then those that name no mate type, each told where it is met first.
fn axioms_by_mate_type() -> String {
    let mut told: Vec<&str> = Vec::new();
    let mut line = |head: String, meant: &dyn Fn(&Axiom) -> bool| {
        let mut words = Vec::new();
        for a in axioms().iter().filter(|a| meant(a)) {
            if told.contains(&a.id.as_str()) {
                words.push(a.id.clone());
            } else {
                words.push(format!("{} {}", a.id, a.title));
                told.push(&a.id);
            }
        }
        format!("- {head}: {}", words.join("; "))
    };
    let mut lines: Vec<String> = mates::ALL
        .iter()
        .map(|kind| {
            let named = |a: &Axiom| a.scope.mates.iter().any(|t| t.kind().name == kind.name);
            line(format!("`{}`", kind.name), &named)
        })
        .collect();
    lines.push(line("any mate".to_owned(), &|a| a.scope.mates.is_empty()));
    lines.join("\n")
}

#[cfg(test)]
mod tests {
    use super::ALL;

    #[test]
    fn every_prompt_file_is_listed() {
        let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../prompts");
        let mut files: Vec<String> = std::fs::read_dir(folder)
            .unwrap()
            .map(|f| f.unwrap().file_name().into_string().unwrap())
            .collect();
        files.sort();
        let listed: Vec<String> = ALL.iter().map(|p| format!("{}.md", p.name)).collect();
        assert_eq!(files, listed);
    }
}
