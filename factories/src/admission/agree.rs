//! Whether a source declares what was asked for, and whether what it declares does anything.

use assemcad_model::diagnostic::{Code, Diagnostic};
use assemcad_model::name::nearest;
use assemcad_model::param::{ParamKind, ParamSpec};
use assemcad_script::Factory;
use serde_json::json;

use super::gate::Tried;
use super::report::{Finding, Layer};
use super::request::Request;
use super::sets::differing;
use super::trial::Outcome;

/// The parameters that are asked for and not declared so.
pub(super) fn agree(factory: &Factory, request: &Request) -> Vec<Finding> {
    let mut found = Vec::new();
    for asked in request.specs() {
        let place = format!("factory {}, params.{}", factory.name(), asked.name);
        let declared = factory.params().iter().find(|p| p.name == asked.name);
        let d = match declared {
            Some(declared) if same(&declared.kind, &asked.kind) => continue,
            Some(declared) => Diagnostic::error(
                Code::FactoryFailed,
                place,
                format!(
                    "the source declares '{}' as {} with the default {}, and the request asks for {} with \
                     the default {}",
                    asked.name,
                    declared.expected(),
                    declared.default_value(),
                    asked.expected(),
                    asked.default_value()
                ),
            )
            .found(declared.schema())
            .expected(asked.schema())
            .hint("declare it as it was asked for, or change the request"),
            None => {
                let names = factory.params().iter().map(|p| p.name.as_str());
                let near = nearest(&asked.name, names, 1);
                let d = Diagnostic::error(
                    Code::FactoryFailed,
                    place,
                    format!("the source does not declare the parameter '{}'", asked.name),
                )
                .expected(asked.schema());
                match near.first() {
                    Some(near) => d.hint(format!("it declares '{near}': call it '{}'", asked.name)),
                    None => d.hint("add it to params of factory(...) and use it in build(p)"),
                }
            }
        };
        found.push(Finding::of(Layer::Execution, d));
    }
    found
}

fn same(declared: &ParamKind, asked: &ParamKind) -> bool {
    match (declared, asked) {
        (
            ParamKind::Number {
                min, max, default, ..
            },
            ParamKind::Number {
                min: a,
                max: b,
                default: c,
                ..
            },
        ) => (min, max, default) == (a, b, c),
        (
            ParamKind::Choice { choices, default },
            ParamKind::Choice {
                choices: words,
                default: word,
            },
        ) => {
            let sorted = |list: &[String]| {
                let mut list = list.to_vec();
                list.sort();
                list
            };
            default == word && sorted(choices) == sorted(words)
        }
        _ => declared == asked,
    }
}

/// Parameters that were asked for and change nothing: the recipe is the defaults' at both ends.
pub(super) fn without_effect(
    factory: &Factory,
    request: &Request,
    tried: &[Tried],
) -> Vec<Finding> {
    let recipe = |outcome: &Outcome| match outcome {
        Outcome::Made(made) => Some(made.built.recipe.clone()),
        _ => None,
    };
    let Some(at_defaults) = tried.first().and_then(|(_, _, o)| recipe(o)) else {
        return Vec::new();
    };
    let idle = |spec: &ParamSpec| {
        let mut made = tried
            .iter()
            .filter(|(_, set, _)| {
                let differs = differing(factory.params(), set);
                differs.len() == 1 && differs.contains_key(&spec.name)
            })
            .filter_map(|(_, _, o)| recipe(o))
            .peekable();
        // Where no end could be made, its own fault has been told.
        made.peek().is_some() && made.all(|recipe| recipe == at_defaults)
    };
    let asked = request.specs();
    asked
        .iter()
        .filter(|spec| idle(spec))
        .map(|spec| {
            let d = Diagnostic::error(
                Code::FactoryFailed,
                format!("factory {}, params.{}", factory.name(), spec.name),
                format!("the parameter '{}' changes nothing: the part is the same at both ends of its range", spec.name),
            )
            .expected(json!(spec.expected()))
            .hint(format!("use p.{} in build(p)", spec.name));
            Finding::of(Layer::Execution, d)
        })
        .collect()
}
