//! Solids in their places, their boxes in the world, and what is asked once for all parts of one recipe.

use std::collections::BTreeMap;
use std::sync::Arc;

use assemcad_factories::failure::diagnostic;
use assemcad_geometry::{Asker, PlacedSolid};
use assemcad_kernel::protocol::{Built, CommonVolume};
use assemcad_model::diagnostic::Diagnostic;
use assemcad_model::frame::Placement;
use assemcad_model::report::rounded;
use futures::future::join_all;

use crate::place::Placements;
use crate::resolved::{Resolved, ResolvedPart};

/// How much the boxes of solids are widened before they count as apart, in mm. Wider than any
/// tolerance that the kernel leaves on a valid solid.
pub const BOX_MARGIN_MM: f64 = 1e-3;

/// Smallest and largest corner of a box, in mm.
pub type Box3 = ([f64; 3], [f64; 3]);

/// An assembly whose parts are resolved, placed and made, as far as they can be.
#[derive(Debug, Clone, Copy)]
pub struct Assembled<'a> {
    /// The parts and mates.
    pub resolved: &'a Resolved,
    /// Where the parts are.
    pub placements: &'a Placements,
    /// What was measured of each part's solid; none for parts that could not be made.
    pub built: &'a [Option<Built>],
}

impl<'a> Assembled<'a> {
    /// A part's solid in its place.
    #[must_use]
    pub fn solid(&self, part: usize) -> Option<PlacedSolid> {
        let (part, at) = (self.resolved.parts.get(part)?, self.placements.of(part)?);
        Some(part.solid_at(&at))
    }

    /// What was measured of a part's solid.
    #[must_use]
    pub fn built(&self, part: usize) -> Option<&'a Built> {
        self.built.get(part)?.as_ref()
    }

    /// A box in the world around a placed part.
    #[must_use]
    pub fn world_box(&self, part: usize) -> Option<Box3> {
        Some(box_of(self.built(part)?, &self.placements.of(part)?))
    }
}

/// Makes a part's solid and measures it.
///
/// # Errors
/// Why there is no such solid, with the operation and its line in the factory's source.
pub async fn build(door: Asker<'_>, part: &ResolvedPart) -> Result<Built, Diagnostic> {
    let built = door.build(&part.made.solid).await;
    built.map_err(|failure| part.failed(&failure))
}

/// Makes the solids of all parts, in their order.
pub async fn build_all(door: Asker<'_>, resolved: &Resolved) -> Vec<Result<Built, Diagnostic>> {
    join_all(resolved.parts.iter().map(|p| build(door, p))).await
}

/// The volume that the solids of two parts have in common; `names` are the parts'.
///
/// # Errors
/// Why it is not known.
pub async fn common_volume(
    door: Asker<'_>,
    (a, b): (PlacedSolid, PlacedSolid),
    samples: u32,
    names: [&str; 2],
) -> Result<CommonVolume, Diagnostic> {
    let [name_a, name_b] = names;
    let volume = door.common_volume(&a, &b, samples).await;
    volume.map_err(|f| diagnostic(&f, &format!("parts '{name_a}' and '{name_b}'")))
}

/// Asks once about all made parts of one recipe, and gives each part its answer, in their order; none for
/// parts that could not be made.
pub async fn once_per_recipe<'a, F: Future>(
    resolved: &'a Resolved,
    built: &'a [Option<Built>],
    ask: impl Fn(&'a ResolvedPart, &'a Built) -> F,
) -> Vec<Option<Arc<F::Output>>> {
    let mut distinct: BTreeMap<&str, (&ResolvedPart, &Built)> = BTreeMap::new();
    for (part, built) in resolved.parts.iter().zip(built) {
        if let Some(b) = built {
            distinct.entry(&b.recipe).or_insert((part, b));
        }
    }
    let answers = join_all(distinct.values().map(|(part, b)| ask(part, b))).await;
    let answers = answers.into_iter().map(Arc::new);
    let answers: BTreeMap<&str, Arc<F::Output>> = distinct.keys().copied().zip(answers).collect();
    let of = |built: &Option<Built>| answers.get(built.as_ref()?.recipe.as_str()).cloned();
    built.iter().map(of).collect()
}

/// A solid at another place.
#[must_use]
pub fn moved(solid: &PlacedSolid, to: &Placement) -> PlacedSolid {
    PlacedSolid {
        solid: solid.solid.clone(),
        at: *to,
    }
}

/// A box in the world around a placed part: the box of its own box's corners.
#[must_use]
pub fn box_of(b: &Built, at: &Placement) -> Box3 {
    let (mut min, mut max) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
    for x in [b.min[0], b.max[0]] {
        for y in [b.min[1], b.max[1]] {
            for z in [b.min[2], b.max[2]] {
                for (k, v) in at.point([x, y, z]).into_iter().enumerate() {
                    if let (Some(lo), Some(hi)) = (min.get_mut(k), max.get_mut(k)) {
                        *lo = lo.min(v);
                        *hi = hi.max(v);
                    }
                }
            }
        }
    }
    (min, max)
}

/// A box as it is reported.
#[must_use]
pub fn reported((min, max): &Box3) -> [[f64; 3]; 2] {
    [min.map(rounded), max.map(rounded)]
}

/// The pairs of boxes that are not further apart than the margin, in order. Swept along the axis along which they
/// are spread the most.
#[must_use]
pub fn near_pairs(boxes: &[Option<Box3>], margin_mm: f64) -> Vec<(usize, usize)> {
    let known = boxes.iter().enumerate();
    let known = known.filter_map(|(i, b)| Some((i, b.as_ref()?)));
    let number = |(_, b): &(usize, &Box3)| b.0.iter().chain(&b.1).all(|x| x.is_finite());
    // A box that is no number is apart from nothing, and has no place in a row.
    let (mut row, odd): (Vec<_>, Vec<_>) = known.partition(number);
    let at = |p: &[f64; 3], axis: usize| p.get(axis).copied().unwrap_or_default();
    let spread = |axis: usize| {
        let lows = row.iter().map(|(_, b)| at(&b.0, axis));
        let ends = (f64::INFINITY, f64::NEG_INFINITY);
        let (low, high) = lows.fold(ends, |(l, h), x| (l.min(x), h.max(x)));
        high - low
    };
    let axis = (0..3).fold(0, |a, b| if spread(b) > spread(a) { b } else { a });
    row.sort_by(|(i, a), (j, b)| {
        let order = at(&a.0, axis).total_cmp(&at(&b.0, axis));
        order.then(i.cmp(j))
    });
    let mut out = Vec::new();
    for (n, (i, a)) in row.iter().enumerate() {
        let beside = row.iter().skip(n + 1);
        let beside = beside.take_while(|(_, b)| at(&b.0, axis) <= at(&a.1, axis) + margin_mm);
        let near = beside.filter(|(_, b)| !apart(a, b, margin_mm));
        out.extend(near.map(|(j, _)| (*i.min(j), *i.max(j))));
    }
    for (n, (i, a)) in odd.iter().enumerate() {
        let others = row.iter().chain(odd.iter().skip(n + 1));
        let near = others.filter(|(_, b)| !apart(a, b, margin_mm));
        out.extend(near.map(|(j, _)| (*i.min(j), *i.max(j))));
    }
    out.sort_unstable();
    out
}

/// Whether two boxes are further apart than the margin.
#[must_use]
pub fn apart((a_min, a_max): &Box3, (b_min, b_max): &Box3, margin_mm: f64) -> bool {
    let gap =
        |min: &[f64; 3], max: &[f64; 3]| min.iter().zip(max).any(|(lo, hi)| *lo > *hi + margin_mm);
    gap(a_min, b_max) || gap(b_min, a_max)
}

#[cfg(test)]
mod tests {
    use super::BOX_MARGIN_MM;

    #[test]
    fn boxes_that_touch_are_not_apart() {
        let apart = |a, b| super::apart(a, b, BOX_MARGIN_MM);
        let a = ([0.0; 3], [1.0; 3]);
        assert!(!apart(&a, &([1.0, 0.0, 0.0], [2.0, 1.0, 1.0])));
        assert!(!apart(&a, &([0.2; 3], [0.8; 3])));
        assert!(apart(&a, &([0.0, 0.0, 1.01], [1.0, 1.0, 2.0])));
        assert!(apart(&([0.0, 0.0, 1.01], [1.0, 1.0, 2.0]), &a));
        // A box that is no number is apart from nothing.
        assert!(!apart(&([f64::NAN; 3], [f64::NAN; 3]), &a));
    }

    /// Boxes in a row, in a plane and all about: what a sweep finds is what all pairs have.
    #[test]
    fn a_sweep_finds_the_pairs_that_are_near() {
        let mut at = 0.37_f64;
        let mut next = || {
            at = (at * 997.0 + 0.123).fract();
            at
        };
        for [x, y, z] in [[90.0, 1.0, 1.0], [1.0, 30.0, 30.0], [9.0, 9.0, 9.0]] {
            let boxes: Vec<Option<([f64; 3], [f64; 3])>> = (0..120)
                .map(|i| {
                    let low = [x * next(), y * next(), z * next()];
                    let size = [next(), 2.0 * next(), next()];
                    let high = core::array::from_fn(|k| low[k] + size[k]);
                    let low = if i == 50 || i == 70 {
                        [f64::NAN, low[1], f64::NAN]
                    } else {
                        low
                    };
                    (i % 11 != 0).then_some((low, high))
                })
                .collect();
            for margin in [0.0, 0.5] {
                let mut wanted = Vec::new();
                for (i, a) in boxes.iter().enumerate() {
                    for (j, b) in boxes.iter().enumerate().skip(i + 1) {
                        if let (Some(a), Some(b)) = (a, b)
                            && !super::apart(a, b, margin)
                        {
                            wanted.push((i, j));
                        }
                    }
                }
                assert!(wanted.len() > 5);
                assert_eq!(super::near_pairs(&boxes, margin), wanted);
            }
        }
    }
}
