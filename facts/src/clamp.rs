//! What lies in the grip of a screw: the parts through which its pull goes back to its thread.

use std::collections::BTreeSet;

use assemcad_geometry::narrow::meet::{Kind, Meeting};
use nalgebra::Vector3;

use crate::groups::Engaged;
use crate::hold::Placed;
use crate::stops::stops;

/// A contact passes the pull on where its normal goes along it by this cosine: countersunk heads do.
const ALONG: f64 = 0.3;

/// The parts between a screw's head, or its end, and its thread; none where the stack gapes anywhere.
pub(crate) fn grip(of: &Placed<'_>, engaged: &[Engaged], e: &Engaged) -> BTreeSet<usize> {
    // A stud's nut pulls against what the stud is screwed into.
    let others = engaged
        .iter()
        .filter(|o| o.screw == e.screw && o.nut != e.nut);
    let heads: BTreeSet<usize> = [e.screw].into_iter().chain(others.map(|o| o.nut)).collect();
    let onward = |part: usize, way: &Vector3<f64>| -> Vec<usize> {
        let pairs = of.pairs.iter().filter(|p| p.a == part || p.b == part);
        let next = pairs.filter_map(|p| {
            let (other, sign) = if p.a == part { (p.b, 1.0) } else { (p.a, -1.0) };
            let presses = |m: &Meeting| {
                // Round fits close by their play where they are pushed aside.
                let near = m.touches() || (m.kind == Kind::Cylinder && stops(m));
                let along = |n: [f64; 3]| Vector3::from(n).dot(way) * sign > ALONG;
                near && m.spots.iter().any(|s| along(s.normal))
            };
            p.meetings.iter().any(presses).then_some(other)
        });
        next.collect()
    };
    let reach = |from: &BTreeSet<usize>, way: &Vector3<f64>, stop: &BTreeSet<usize>| {
        let mut found = BTreeSet::new();
        let mut open: Vec<usize> = from.iter().copied().collect();
        while let Some(part) = open.pop() {
            for next in onward(part, way) {
                if !from.contains(&next) && found.insert(next) && !stop.contains(&next) {
                    open.push(next);
                }
            }
        }
        found
    };
    let nut = BTreeSet::from([e.nut]);
    let forth = reach(&heads, &e.way, &nut);
    let back = reach(&nut, &-e.way, &heads);
    if !forth.contains(&e.nut) {
        return BTreeSet::new();
    }
    forth.intersection(&back).copied().collect()
}
