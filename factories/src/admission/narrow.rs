//! The ranges within which a factory was shown to work, where it does not work in all that it declares.
//!
//! Each range is drawn in towards the default until its ends are good alone, then all of them together
//! until the corners and what lies between are good too. What comes out is examined as a whole again.

use std::collections::BTreeMap;

use assemcad_model::param::{ParamKind, ParamSpec};
use assemcad_script::Factory;
use futures::stream::{self, StreamExt};
use serde_json::Value;

use super::gate::examine;
use super::record::ranges;
use super::report::Evidence;
use super::request::Request;
use super::sets::Set;
use super::trial::{Outcome, Trial};

/// How often an end is halved towards the default.
const HALVINGS: usize = 5;

/// How often all ranges together are drawn in, and to what share.
const DRAWN_IN: usize = 8;
const SHARE: f64 = 0.75;

/// The factory within the ranges in which it works, its evidence there, and which ranges were drawn in;
/// none where it works at its defaults only.
pub(super) async fn narrow(
    trial: &Trial<'_>,
    factory: &Factory,
    request: &Request,
) -> Option<(Factory, Evidence, BTreeMap<String, [f64; 2]>)> {
    let mut specs = factory.params().to_vec();
    // Each end is looked for with all else at its default: none waits for another.
    let wanted = specs.iter().enumerate().filter_map(|(i, spec)| {
        let ends = Ends::of(spec)?;
        Some([(i, ends.default, ends.low), (i, ends.default, ends.high)])
    });
    let wanted: Vec<(usize, f64, f64)> = wanted.flatten().collect();
    let declared = &specs;
    let each = wanted.into_iter().map(|(i, default, far)| async move {
        let good = end(trial, factory, request, declared, i, (default, far)).await;
        (i, far, good)
    });
    let found = stream::iter(each).buffered(2 * trial.gate.door.processes());
    for (i, far, good) in found.collect::<Vec<_>>().await {
        let Some((spec, mut ends)) = specs
            .get_mut(i)
            .and_then(|s| Ends::of(s).map(|ends| (s, ends)))
        else {
            continue;
        };
        if far < ends.default {
            ends.low = good;
        } else if far > ends.default {
            ends.high = good;
        }
        ends.put(spec);
    }
    for _ in 0..DRAWN_IN {
        if trial.is_over() {
            return None;
        }
        let drawn = factory.clone().within(specs.clone());
        let asked = within(request, &specs);
        let report = examine(trial, &drawn, &asked).await;
        if let Some(evidence) = report.evidence {
            let drawn_in = ranges(factory.params(), &specs);
            return specs
                .iter()
                .any(varies)
                .then_some((drawn, evidence, drawn_in));
        }
        for spec in &mut specs {
            if let Some(mut ends) = Ends::of(spec) {
                ends.low = ends.default + SHARE * (ends.low - ends.default);
                ends.high = ends.default + SHARE * (ends.high - ends.default);
                ends.put(spec);
            }
        }
    }
    None
}

/// The request with the narrowed ranges in the place of its own.
fn within(request: &Request, specs: &[ParamSpec]) -> Request {
    let mut request = request.clone();
    for asked in &mut request.params {
        let ends = specs
            .iter()
            .find(|s| s.name == asked.name)
            .and_then(Ends::of);
        if let Some(ends) = ends {
            (asked.min, asked.max) = (Some(ends.low), Some(ends.high));
        }
    }
    request
}

/// The outermost good value from the default towards an end, the other parameters at their defaults.
async fn end(
    trial: &Trial<'_>,
    factory: &Factory,
    request: &Request,
    specs: &[ParamSpec],
    index: usize,
    (default, end): (f64, f64),
) -> f64 {
    let (mut good, mut tried) = (default, end);
    for n in 0..=HALVINGS {
        let mut specs = specs.to_vec();
        let Some(spec) = specs.get_mut(index) else {
            return good;
        };
        let value = rounded_inwards(spec, tried, default);
        if value == good || is_good(trial, factory, request, &specs, (index, value)).await {
            good = value;
            if n == 0 {
                return good;
            }
            tried = good + (end - default) / f64::from(1 << (n + 1).min(30));
        } else {
            tried = value - (end - default) / f64::from(1 << (n + 1).min(30));
        }
    }
    good
}

async fn is_good(
    trial: &Trial<'_>,
    factory: &Factory,
    request: &Request,
    specs: &[ParamSpec],
    (index, value): (usize, f64),
) -> bool {
    let each = specs.iter().enumerate().map(|(i, spec)| {
        let value = if i == index {
            as_json(spec, value)
        } else {
            spec.default_value()
        };
        (spec.name.clone(), value)
    });
    let set: Set = each.collect();
    // Behind the limit nothing is good, and nothing comes of it.
    !trial.expired()
        && !matches!(
            trial.outcome(factory, request, &set).await,
            Outcome::Failed(_)
        )
}

fn as_json(spec: &ParamSpec, value: f64) -> Value {
    match spec.kind {
        ParamKind::Integer { .. } => Value::from(value as i64),
        _ => Value::from(value),
    }
}

/// Three decimals, whole for whole numbers, towards the default.
fn rounded_inwards(spec: &ParamSpec, value: f64, default: f64) -> f64 {
    let step = match spec.kind {
        ParamKind::Integer { .. } => 1.0,
        _ => 1e-3,
    };
    let steps = (value - default) / step;
    // An end as it is declared stays what it is.
    if (libm::round(steps) - steps).abs() < 1e-6 {
        return value;
    }
    default + libm::trunc(steps) * step
}

/// The range of a parameter that has one.
#[derive(Debug, Clone)]
struct Ends {
    low: f64,
    default: f64,
    high: f64,
}

impl Ends {
    fn of(spec: &ParamSpec) -> Option<Self> {
        let [low, high] = spec.range()?;
        let default = spec.default_value().as_f64()?;
        Some(Self { low, default, high })
    }

    fn put(&self, spec: &mut ParamSpec) {
        let inwards = |end| rounded_inwards(spec, end, self.default);
        let range = [inwards(self.low), inwards(self.high)];
        spec.set_range(range);
    }
}

fn varies(spec: &ParamSpec) -> bool {
    match &spec.kind {
        ParamKind::Choice { choices, .. } => choices.len() > 1,
        ParamKind::Flag { .. } => true,
        _ => spec.range().is_some_and(|[low, high]| high > low),
    }
}
