//! `factory(...)` and the declarations of parameters.
#![allow(missing_docs, reason = "the macro makes public items of the functions")]

use assemcad_model::param::{ParamKind, ParamSpec, check_all};
use serde_json::{Map, Value as Json, json};
use starlark::environment::GlobalsBuilder;
use starlark::eval::Evaluator;
use starlark::starlark_module;
use starlark::values::dict::DictRef;
use starlark::values::none::NoneType;
use starlark::values::{UnpackValue, Value};

use super::guard::written_length;
use super::session::{Declaration, Session};
use super::{items, number};
use crate::fault::Fault;
use crate::values::Param;

/// Units that a number may have.
const UNITS: [&str; 4] = ["", "mm", "deg", "N"];

/// Most parameters of a factory, and most fields of a record.
const MOST_PARAMS: usize = 100;

/// Deepest nesting of records: their readers walk them by recursion.
const DEEPEST_RECORDS: usize = 4;

/// How deep records are nested in fields.
fn depth(fields: &[ParamSpec]) -> usize {
    let inner = fields.iter().map(|field| match &field.kind {
        ParamKind::Records { fields, .. } => 1 + depth(fields),
        _ => 0,
    });
    inner.max().unwrap_or(0)
}

fn integer(value: Value<'_>, what: &str) -> Result<i64, Fault> {
    match i64::unpack_value(value) {
        Ok(Some(n)) => Ok(n),
        _ => Err(Fault::new(format!(
            "{what} is a whole number, not a {}",
            value.get_type()
        ))),
    }
}

fn count(value: Value<'_>, what: &str) -> Result<usize, Fault> {
    usize::try_from(integer(value, what)?).map_err(|_| Fault::new(format!("{what} is 0 or more")))
}

/// The named parameters of a dict, checked against their own defaults.
fn specs(dict: Value<'_>, what: &str) -> Result<Vec<ParamSpec>, Fault> {
    let wrong = || {
        Fault::new(format!("{what} is a dict of names and declarations"))
            .hint("write {\"length\": number(80, 1, 1000, doc = \"extent along x\")}")
    };
    let dict = DictRef::from_value(dict).ok_or_else(wrong)?;
    if dict.len() > MOST_PARAMS {
        return Err(Fault::new(format!(
            "{what} has more than {MOST_PARAMS} entries"
        )));
    }
    let mut specs = Vec::new();
    for (name, param) in dict.iter() {
        let name = name.unpack_str().ok_or_else(wrong)?;
        check_name(name)?;
        let param = Param::from_value(param).ok_or_else(wrong)?;
        let mut spec = ParamSpec {
            name: name.to_owned(),
            doc: param.doc.clone(),
            kind: param.kind.clone(),
        };
        let default = Map::from_iter([(name.to_owned(), spec.default_value())]);
        let checked = check_all(std::slice::from_ref(&spec), &default, "default").map_err(|d| {
            let first = d.first().map(ToString::to_string).unwrap_or_default();
            Fault::new(format!("the default of '{name}' is not valid: {first}"))
        })?;
        if let (ParamKind::Records { default, .. }, Some(Json::Array(normal))) =
            (&mut spec.kind, checked.get(name))
        {
            default.clone_from(normal);
        }
        specs.push(spec);
    }
    Ok(specs)
}

/// Parameters are read as `p.name`, so a name is one that can stand there.
fn check_name(name: &str) -> Result<(), Fault> {
    let plain = name.starts_with(|c: char| c.is_ascii_lowercase())
        && name
            .chars()
            .all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_')
        && name.len() <= assemcad_model::name::MAX_LENGTH;
    let taken = crate::scan::UNGUARDED_METHODS
        .iter()
        .any(|(method, _)| *method == name);
    if plain && !taken {
        return Ok(());
    }
    Err(Fault::new(format!(
        "'{}' cannot name a parameter",
        assemcad_model::param::clip(name)
    ))
    .hint("names are a-z, 0-9 and '_', the first a letter, and not a method of texts"))
}

#[starlark_module]
pub(super) fn functions(builder: &mut GlobalsBuilder) {
    /// `factory(doc = "...", params = {...})`: what the source makes; called once, at the top level.
    fn factory<'v>(
        #[starlark(require = named)] doc: &str,
        #[starlark(require = named)] params: Value<'v>,
        eval: &mut Evaluator<'v, '_, '_>,
    ) -> anyhow::Result<NoneType> {
        let session = Session::of(eval)?;
        if session.building.get() || session.declaration.borrow().is_some() {
            // The top level runs again before build(p), each time with a new session.
            return Fault::new("factory(...) is called more than once")
                .hint("call it once, at the top level")
                .raise();
        }
        let doc = doc.trim().to_owned();
        let params = specs(params, "params")?;
        *session.declaration.borrow_mut() = Some(Declaration { doc, params });
        Ok(NoneType)
    }

    /// `number(default, min, max, unit = "mm", doc = "...")`: a real number.
    #[starlark(speculative_exec_safe)]
    fn number<'v>(
        default: Value<'v>,
        min: Value<'v>,
        max: Value<'v>,
        #[starlark(require = named, default = "mm")] unit: &str,
        #[starlark(require = named, default = "")] doc: &str,
    ) -> anyhow::Result<Param> {
        if !UNITS.contains(&unit) {
            return Fault::new(format!("unit is one of: {}", UNITS.join(", "))).raise();
        }
        let (min, max) = (number(min, "min")?, number(max, "max")?);
        let default = number(default, "default")?;
        if min > max {
            return Fault::new(format!("min {min} is over max {max}")).raise();
        }
        let kind = ParamKind::Number {
            unit: unit.to_owned(),
            min,
            max,
            default,
        };
        Ok(Param {
            doc: doc.to_owned(),
            kind,
        })
    }

    /// `integer(default, min, max, doc = "...")`: a whole number.
    fn integer<'v>(
        default: Value<'v>,
        min: Value<'v>,
        max: Value<'v>,
        #[starlark(require = named, default = "")] doc: &str,
    ) -> anyhow::Result<Param> {
        let (min, max) = (integer(min, "min")?, integer(max, "max")?);
        let default = integer(default, "default")?;
        if min > max {
            return Fault::new(format!("min {min} is over max {max}")).raise();
        }
        Ok(Param {
            doc: doc.to_owned(),
            kind: ParamKind::Integer { min, max, default },
        })
    }

    /// `choice(default, choices, doc = "...")`: one of a list of words.
    fn choice<'v>(
        default: &str,
        choices: Value<'v>,
        #[starlark(require = named, default = "")] doc: &str,
    ) -> anyhow::Result<Param> {
        let words = items(choices).and_then(|list| {
            list.into_iter()
                .map(|v| v.unpack_str().map(str::to_owned))
                .collect::<Option<Vec<_>>>()
        });
        let Some(choices) = words.filter(|w| !w.is_empty()) else {
            return Fault::new("choices is a list of texts").raise();
        };
        let kind = ParamKind::Choice {
            choices,
            default: default.to_owned(),
        };
        Ok(Param {
            doc: doc.to_owned(),
            kind,
        })
    }

    /// `flag(default, doc = "...")`: True or False.
    fn flag(
        default: bool,
        #[starlark(require = named, default = "")] doc: &str,
    ) -> anyhow::Result<Param> {
        Ok(Param {
            doc: doc.to_owned(),
            kind: ParamKind::Flag { default },
        })
    }

    /// `records(fields = {...}, default = [...], min_items = 1, max_items = 20, doc = "...")`: a list
    /// of records with the same fields.
    fn records<'v>(
        #[starlark(require = named)] fields: Value<'v>,
        #[starlark(require = named)] default: Value<'v>,
        #[starlark(require = named)] min_items: Value<'v>,
        #[starlark(require = named)] max_items: Value<'v>,
        #[starlark(require = named, default = "")] doc: &str,
        eval: &mut Evaluator<'v, '_, '_>,
    ) -> anyhow::Result<Param> {
        written_length(default, &Session::of(eval)?.limits)?;
        let Ok(Json::Array(default)) = default.to_json_value() else {
            return Fault::new("default is a list of dicts").raise();
        };
        let fields = specs(fields, "fields")?;
        if depth(&fields) >= DEEPEST_RECORDS {
            return Fault::new(format!(
                "records are nested more than {DEEPEST_RECORDS} deep"
            ))
            .hint("give the inner fields to the outer record")
            .raise();
        }
        let kind = ParamKind::Records {
            fields,
            min_items: count(min_items, "min_items")?,
            max_items: count(max_items, "max_items")?,
            default: default.into_iter().map(|v| json!(v)).collect(),
        };
        Ok(Param {
            doc: doc.to_owned(),
            kind,
        })
    }
}
