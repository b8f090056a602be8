//! Arguments of a call, put to the parameters that they are for.

use assemcad_model::language::{Default, Kind, Param};
use assemcad_model::name::nearest;
use assemcad_model::param::clip;
use starlark::eval::Arguments;
use starlark::values::{Heap, Value};

use crate::fault::Fault;

/// The arguments of a call as they were written.
pub(crate) struct Given<'v> {
    pub(crate) positions: Vec<Value<'v>>,
    pub(crate) named: Vec<(&'v str, Value<'v>)>,
}

impl<'v> Given<'v> {
    pub(crate) fn of(args: &Arguments<'v, '_>, heap: Heap<'v>) -> starlark::Result<Self> {
        Ok(Self {
            positions: args.positions(heap)?.collect(),
            named: args
                .names_map()?
                .into_iter()
                .map(|(name, value)| (name.as_str(), value))
                .collect(),
        })
    }

    /// The value of each parameter, where one is given.
    pub(crate) fn bind(
        &self,
        name: &str,
        params: &'static [Param],
    ) -> Result<Vec<Option<Value<'v>>>, Fault> {
        let shown = || signature(name, params.iter());
        if self.positions.len() > params.len() {
            let most = match params.len() {
                0 => "no arguments".to_owned(),
                1 => "one argument".to_owned(),
                n => format!("{n} arguments"),
            };
            return Err(Fault::new(format!(
                "{name} takes {most}, and {} are given",
                self.positions.len()
            ))
            .hint(shown()));
        }
        let mut bound: Vec<Option<Value<'v>>> = vec![None; params.len()];
        for (slot, value) in bound.iter_mut().zip(&self.positions) {
            *slot = Some(*value);
        }
        for (word, value) in &self.named {
            let place = params.iter().position(|p| p.name == *word);
            let Some(slot) = place.and_then(|i| bound.get_mut(i)) else {
                let near = nearest(word, params.iter().map(|p| p.name), 1);
                let hint = match near.first() {
                    Some(near) => format!("did you mean '{near}'? {}", shown()),
                    None => shown(),
                };
                return Err(
                    Fault::new(format!("{name} has no parameter '{}'", clip(word))).hint(hint),
                );
            };
            if slot.is_some() {
                return Err(Fault::new(format!("{name} is given '{word}' twice")).hint(shown()));
            }
            *slot = Some(*value);
        }
        let missing: Vec<String> = params
            .iter()
            .zip(&bound)
            .filter(|(p, value)| p.default == Default::Required && value.is_none())
            .map(|(p, _)| format!("'{}'", p.name))
            .collect();
        if missing.is_empty() {
            Ok(bound)
        } else {
            Err(Fault::new(format!("{name} lacks {}", missing.join(" and "))).hint(shown()))
        }
    }
}

/// How a function is called: its parameters with their defaults.
pub(crate) fn signature<'a>(name: &str, params: impl Iterator<Item = &'a Param>) -> String {
    let params: Vec<String> = params.map(parameter).collect();
    format!("{name}({})", params.join(", "))
}

fn parameter(param: &Param) -> String {
    let name = param.name;
    let number = |n: f64| format!("{n}");
    match param.default {
        Default::Required => name.to_owned(),
        Default::None => format!("{name}=None"),
        Default::Flag(true) => format!("{name}=True"),
        Default::Flag(false) => format!("{name}=False"),
        Default::Real(n) => format!("{name}={}", number(n)),
        Default::Count(n) => format!("{name}={n}"),
        Default::Text(text) => match param.kind {
            Kind::Choice(choices) => {
                let others: Vec<String> = choices
                    .iter()
                    .filter(|c| **c != text)
                    .map(|c| format!("\"{c}\""))
                    .collect();
                format!("{name}=\"{text}\"|{}", others.join("|"))
            }
            _ => format!("{name}=\"{text}\""),
        },
        Default::Vector([x, y, z]) => format!("{name}=({x},{y},{z})"),
    }
}
