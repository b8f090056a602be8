//! The bodies of an assembly, looked at along axes: only pairs whose shadows meet, each once.

use std::collections::BTreeMap;

use nalgebra::Vector3;

use super::limit::Limit;
use super::rays::{PlacedFacets, Seen, View};
use super::sight::{Passage, Stopped, Stops, look, whether};
use super::tree::{Box3, Tree};

/// A pair of parts by their places, the earlier one first.
pub(super) type Pair = (usize, usize);

/// The bodies, where they pass through each other, and what was seen so far.
pub(super) struct Looker<'a> {
    bodies: &'a [Option<PlacedFacets>],
    passages: BTreeMap<Pair, Vec<Passage>>,
    limit: &'a Limit,
    views: Vec<Sighting>,
}

/// What the bodies look like along an axis, and what was found for pairs.
struct Sighting {
    view: View,
    seen: Vec<Option<Seen>>,
    /// The pairs whose shadows meet, in order.
    near: Vec<Pair>,
    stops: BTreeMap<Pair, Stops>,
    stopped: BTreeMap<Pair, Stopped>,
}

impl Sighting {
    fn new(axis: &Vector3<f64>, bodies: &[Option<PlacedFacets>]) -> Self {
        let view = View::along(*axis);
        let seen = |b: &Option<PlacedFacets>| b.as_ref().map(|b| b.seen(&view));
        let seen: Vec<Option<Seen>> = bodies.iter().map(seen).collect();
        let there = seen.iter().enumerate();
        let (at, shadows): (Vec<usize>, Vec<Box3>) = there
            .filter_map(|(i, s)| {
                let s = s.as_ref()?;
                let low = Box3::NONE.with([s.low.x, s.low.y, 0.0]);
                Some((i, low.with([s.high.x, s.high.y, 0.0])))
            })
            .unzip();
        let tree = Tree::new(&shadows);
        let mut near = Vec::new();
        for (i, shadow) in at.iter().zip(&shadows) {
            tree.visit(
                |b| b.meets(shadow),
                |k| {
                    if let (Some(j), Some(other)) = (at.get(k), shadows.get(k))
                        && j > i
                        && other.meets(shadow)
                    {
                        near.push((*i, *j));
                    }
                },
            );
        }
        near.sort_unstable();
        Self {
            view,
            seen,
            near,
            stops: BTreeMap::new(),
            stopped: BTreeMap::new(),
        }
    }

    fn both(&self, (i, j): Pair) -> Option<(&Seen, &Seen)> {
        Some((self.seen.get(i)?.as_ref()?, self.seen.get(j)?.as_ref()?))
    }

    /// How far two bodies are apart along the axis, in mm; below 0 where they are beside each other in part.
    fn gap(&self, pair: Pair) -> f64 {
        self.both(pair).map_or(f64::INFINITY, |(a, b)| {
            (b.low.z - a.high.z).max(a.low.z - b.high.z)
        })
    }
}

impl<'a> Looker<'a> {
    pub(super) fn new(
        bodies: &'a [Option<PlacedFacets>],
        passages: BTreeMap<Pair, Vec<Passage>>,
        limit: &'a Limit,
    ) -> Self {
        Self {
            bodies,
            passages,
            limit,
            views: Vec::new(),
        }
    }

    /// Where the two bodies of a pair pass through each other.
    fn passages(&self, pair: Pair) -> &[Passage] {
        self.passages
            .get(&pair)
            .map(Vec::as_slice)
            .unwrap_or_default()
    }

    /// The sighting along an axis, a unit vector, and whether it looks the same way.
    fn sighting(&mut self, axis: &Vector3<f64>) -> (usize, bool) {
        let parallel = |s: &Sighting| s.view.d.cross(axis).norm() <= 1e-9;
        let at = self.views.iter().position(parallel).unwrap_or_else(|| {
            self.views.push(Sighting::new(axis, self.bodies));
            self.views.len() - 1
        });
        let view = self.views.get(at);
        (at, view.is_some_and(|s| s.view.d.dot(axis) > 0.0))
    }

    /// Who stops whom along an axis, of the pairs that are wanted; none where that was more work than is allowed.
    pub(super) fn stops(
        &mut self,
        axis: &Vector3<f64>,
        wanted: impl Fn(Pair) -> bool,
    ) -> Option<Vec<(Pair, Stops)>> {
        let (at, same) = self.sighting(axis);
        let sighting = self.views.get(at)?;
        let near = sighting.near.iter().copied();
        let pairs: Vec<Pair> = near.filter(|p| wanted(*p)).collect();
        let new = pairs.iter().copied();
        let new: Vec<Pair> = new.filter(|p| !sighting.stops.contains_key(p)).collect();
        let found = self.limit.each(&new, |pair| {
            let (a, b) = sighting.both(*pair)?;
            let (found, work) = whether(&sighting.view, a, b, self.passages(*pair));
            self.limit.take(work).then_some(found)
        })?;
        let sighting = self.views.get_mut(at)?;
        sighting.stops.extend(new.into_iter().zip(found));
        let known = |p: Pair| {
            let found = *sighting.stops.get(&p)?;
            Some((p, if same { found } else { found.turned() }))
        };
        Some(pairs.into_iter().filter_map(known).collect())
    }

    /// How far bodies can go along an axis until they are stopped. Where two are farther apart than `near_mm`, it
    /// is only known that they can go at least so far.
    pub(super) fn stopped(
        &mut self,
        axis: &Vector3<f64>,
        wanted: impl Fn(Pair) -> bool,
        near_mm: f64,
    ) -> Option<Vec<(Pair, Stopped)>> {
        let stops = self.stops(axis, wanted)?;
        let (at, same) = self.sighting(axis);
        let sighting = self.views.get(at)?;
        let stops: Vec<(Pair, Stops)> = stops
            .into_iter()
            .filter(|(_, s)| *s != Stops::default())
            .collect();
        let close = |p: &Pair| sighting.gap(*p) <= near_mm;
        let new: Vec<Pair> = stops
            .iter()
            .map(|(p, _)| *p)
            .filter(|p| close(p) && !sighting.stopped.contains_key(p))
            .collect();
        let found = self.limit.each(&new, |pair| {
            let (a, b) = sighting.both(*pair)?;
            let found = look(&sighting.view, a, b, self.passages(*pair));
            self.limit.take(LOOK).then_some(found)
        })?;
        let sighting = self.views.get_mut(at)?;
        sighting.stopped.extend(new.into_iter().zip(found));
        let known = |(p, stops): (Pair, Stops)| match sighting.stopped.get(&p) {
            Some(found) if same => (p, *found),
            Some(found) => (p, found.turned()),
            None => {
                let gap = sighting.gap(p);
                let play = |stops: bool| stops.then_some(gap);
                (
                    p,
                    Stopped {
                        first: play(stops.first),
                        second: play(stops.second),
                    },
                )
            }
        };
        Some(stops.into_iter().map(known).collect())
    }
}

/// The work of a look that measures: five times all rays.
const LOOK: usize = 100_000;
