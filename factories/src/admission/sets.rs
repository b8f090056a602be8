//! The sets of parameters at which a factory has to show what it makes.
//!
//! The defaults, every end of every range alone, corners of all ranges together, and sets spread evenly
//! between them: always the same ones for the same ranges.

use assemcad_model::canonical;
use assemcad_model::param::{ParamKind, ParamSpec};
use serde_json::{Map, Value, json};

/// So many corners are tried at most: all of them up to five parameters with two ends each.
const MOST_CORNERS: usize = 32;

/// So many sets are spread between the corners.
const SPREAD: usize = 8;

/// A set of parameters, complete.
pub type Set = Map<String, Value>;

/// Where sets come from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Origin {
    /// All defaults.
    Defaults,
    /// One parameter at an end of its range, the others at their defaults.
    End,
    /// Every parameter at an end.
    Corner,
    /// Somewhere between.
    Between,
}

/// The sets of a factory's parameters, each once; the defaults come first, then the ends.
#[must_use]
pub fn sets(specs: &[ParamSpec]) -> Vec<(Origin, Set)> {
    let defaults: Set = specs
        .iter()
        .map(|s| (s.name.clone(), s.default_value()))
        .collect();
    let mut all = vec![(Origin::Defaults, defaults.clone())];
    for spec in specs {
        for end in ends(spec) {
            let mut set = defaults.clone();
            set.insert(spec.name.clone(), end);
            all.push((Origin::End, set));
        }
    }
    all.extend(corners(specs).into_iter().map(|set| (Origin::Corner, set)));
    let between = (1..=SPREAD).map(|n| {
        let each = specs.iter().zip(PRIMES.into_iter().cycle());
        let set = each.map(|(s, prime)| (s.name.clone(), at(s, radical_inverse(n, prime))));
        (Origin::Between, set.collect())
    });
    all.extend(between);
    let mut seen = std::collections::BTreeSet::new();
    all.retain(|(_, set)| seen.insert(canonical::to_bytes(set).unwrap_or_default()));
    all
}

/// What of a set differs from the defaults.
#[must_use]
pub fn differing(specs: &[ParamSpec], set: &Set) -> Set {
    let mut told = set.clone();
    for spec in specs {
        if told.get(&spec.name) == Some(&spec.default_value()) {
            told.remove(&spec.name);
        }
    }
    told
}

/// The values at the ends of a range; of a choice, all words.
fn ends(spec: &ParamSpec) -> Vec<Value> {
    match &spec.kind {
        ParamKind::Number { min, max, .. } => vec![json!(min), json!(max)],
        ParamKind::Integer { min, max, .. } => vec![json!(min), json!(max)],
        ParamKind::Choice { choices, .. } => choices.iter().map(|c| json!(c)).collect(),
        ParamKind::Flag { .. } => vec![json!(false), json!(true)],
        ParamKind::Records {
            min_items,
            max_items,
            default,
            ..
        } => [*min_items, *max_items]
            .into_iter()
            .map(|n| Value::Array(default.iter().cycle().take(n).cloned().collect()))
            .collect(),
    }
}

/// Every combination of ends; where there are too many, as many of them, spread evenly.
fn corners(specs: &[ParamSpec]) -> Vec<Set> {
    let ends: Vec<(&ParamSpec, Vec<Value>)> = specs.iter().map(|s| (s, ends(s))).collect();
    let total = ends
        .iter()
        .try_fold(1_usize, |n, (_, e)| n.checked_mul(e.len().max(1)));
    let pick = |choose: &dyn Fn(usize, usize) -> usize| -> Set {
        let each = ends.iter().enumerate();
        each.filter_map(|(i, (spec, ends))| {
            Some((spec.name.clone(), ends.get(choose(i, ends.len()))?.clone()))
        })
        .collect()
    };
    match total {
        Some(total) if total <= MOST_CORNERS => (0..total)
            .map(|n| {
                let rest = core::cell::Cell::new(n);
                pick(&|_, len| {
                    let index = rest.get() % len.max(1);
                    rest.set(rest.get() / len.max(1));
                    index
                })
            })
            .collect(),
        _ => (1..=MOST_CORNERS)
            .map(|n| {
                pick(&|i, len| {
                    let prime = PRIMES.iter().cycle().nth(i).copied().unwrap_or(2);
                    // A step of its own for each parameter keeps those that share a prime apart.
                    let share = radical_inverse(n + 7 * (i / PRIMES.len()), prime);
                    ((share * len as f64) as usize).min(len.saturating_sub(1))
                })
            })
            .collect(),
    }
}

/// The value at a share of the range.
fn at(spec: &ParamSpec, share: f64) -> Value {
    let index = |len: usize| ((share * len as f64) as usize).min(len.saturating_sub(1));
    match &spec.kind {
        // Three decimals: a set that is told can be read and written again.
        ParamKind::Number { min, max, .. } => {
            let value = libm::round((min + share * (max - min)) * 1000.0) / 1000.0;
            json!(value.clamp(*min, *max))
        }
        ParamKind::Integer { min, max, .. } => {
            let span = (max - min) as f64 + 1.0;
            json!((min + (share * span) as i64).clamp(*min, *max))
        }
        ParamKind::Choice { choices, .. } => json!(choices.get(index(choices.len()))),
        ParamKind::Flag { .. } => json!(share >= 0.5),
        ParamKind::Records {
            min_items,
            max_items,
            default,
            ..
        } => {
            let n = min_items + index(max_items - min_items + 1);
            Value::Array(default.iter().cycle().take(n).cloned().collect())
        }
    }
}

/// The first primes, a base for each parameter.
const PRIMES: [usize; 16] = [2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43, 47, 53];

/// The digits of `n` in a base, mirrored at the point: the van der Corput sequence, of which one base for
/// each dimension makes Halton's points (J. H. Halton, Numerische Mathematik 2, 1960).
fn radical_inverse(mut n: usize, base: usize) -> f64 {
    let (mut value, mut digit) = (0.0, 1.0 / base as f64);
    while n > 0 {
        value += digit * (n % base) as f64;
        digit /= base as f64;
        n /= base;
    }
    value
}

#[cfg(test)]
mod tests {
    use super::{Origin, differing, radical_inverse, sets};
    use assemcad_model::param::{ParamKind, ParamSpec};
    use serde_json::json;

    fn number(name: &str) -> ParamSpec {
        ParamSpec {
            name: name.to_owned(),
            doc: String::new(),
            kind: ParamKind::Number {
                unit: "mm".to_owned(),
                min: 1.0,
                max: 9.0,
                default: 2.0,
            },
        }
    }

    #[test]
    fn the_first_points_of_halton() {
        for (n, base, value) in [
            (1, 2, 0.5),
            (2, 2, 0.25),
            (3, 2, 0.75),
            (6, 2, 0.375),
            (4, 3, 4.0 / 9.0),
        ] {
            assert!((radical_inverse(n, base) - value).abs() < 1e-15);
        }
    }

    #[test]
    fn every_end_and_every_corner_is_there() {
        let specs: Vec<ParamSpec> = ["a", "b", "c"].map(number).into();
        let all = sets(&specs);
        let count = |o: Origin| all.iter().filter(|(of, _)| *of == o).count();
        assert_eq!(
            (
                count(Origin::Defaults),
                count(Origin::End),
                count(Origin::Corner)
            ),
            (1, 6, 8)
        );
        assert_eq!(
            all[0].1,
            json!({"a": 2.0, "b": 2.0, "c": 2.0})
                .as_object()
                .unwrap()
                .clone()
        );
        let b_up = json!({"b": 9.0}).as_object().unwrap().clone();
        assert!(all.iter().any(|(_, s)| differing(&specs, s) == b_up));
        assert_eq!(all, sets(&specs));
    }

    #[test]
    fn of_many_parameters_as_many_corners_as_fit_and_each_end_among_them() {
        let specs: Vec<ParamSpec> = (0..20).map(|i| number(&format!("p{i}"))).collect();
        let all = sets(&specs);
        assert!(all.len() <= 1 + 40 + 32 + 8, "{}", all.len());
        for spec in &specs {
            for end in [1.0, 9.0] {
                let at_end =
                    |o: Origin, s: &super::Set| o == Origin::Corner && s[&spec.name] == json!(end);
                assert!(
                    all.iter().filter(|(o, s)| at_end(*o, s)).count() >= 10,
                    "{}",
                    spec.name
                );
            }
        }
    }
}
