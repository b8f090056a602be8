//! What lies in the grip of a screw: the parts through which its pull goes back to its thread.

use std::collections::{BTreeMap, BTreeSet};

use assemcad_geometry::narrow::meet::{Kind, Meeting};
use nalgebra::Vector3;

use crate::groups::Engaged;
use crate::hold::Placed;
use crate::stops::stops;

/// A contact passes the pull on where its normal goes along it by this cosine: countersunk heads do.
const ALONG: f64 = 0.3;

/// Directions are told apart down to this, in unit vectors.
const SAME_WAY: f64 = 1e-6;

/// A head or an end bears on at least this share of the screw's section. Ours: a head of ISO 4762 on the coarse
/// clearance hole of ISO 273 bears on more than all of it.
const BEARING: f64 = 0.3;

/// Whether points lie all around an axis through the origin.
fn around(arms: &[Vector3<f64>], way: &Vector3<f64>) -> bool {
    let least = way.iamin();
    let mut other = Vector3::zeros();
    if let Some(slot) = other.get_mut(least) {
        *slot = 1.0;
    }
    let x = way.cross(&other).normalize();
    let y = way.cross(&x);
    (0..16_u32).all(|k| {
        let (sin, cos) = libm::sincos(core::f64::consts::TAU * f64::from(k) / 16.0);
        let along = x * cos + y * sin;
        arms.iter().any(|a| a.dot(&along) > 0.0)
    })
}

/// Which parts press on which, along the directions in which screws pull.
pub(crate) struct Presses<'a> {
    of: &'a Placed<'a>,
    /// The pairs of each part.
    pairs: Vec<Vec<usize>>,
    /// The parts that a part presses on along a direction, once they were asked for.
    known: BTreeMap<(usize, [i64; 3]), Vec<usize>>,
}

impl<'a> Presses<'a> {
    pub(crate) fn new(of: &'a Placed<'a>) -> Self {
        let mut pairs = vec![Vec::new(); of.parts];
        for (i, pair) in of.pairs.iter().enumerate() {
            for part in [pair.a, pair.b] {
                if let Some(list) = pairs.get_mut(part) {
                    list.push(i);
                }
            }
        }
        Self {
            of,
            pairs,
            known: BTreeMap::new(),
        }
    }

    /// The parts between a screw's head, or its end, and its thread; none where the stack gapes anywhere.
    pub(crate) fn grip(&mut self, engaged: &[Engaged], e: &Engaged) -> BTreeSet<usize> {
        // A stud's nut pulls against what the stud is screwed into.
        let others = engaged
            .iter()
            .filter(|o| o.screw == e.screw && o.nut != e.nut);
        let heads: BTreeSet<usize> = [e.screw].into_iter().chain(others.map(|o| o.nut)).collect();
        let nut = BTreeSet::from([e.nut]);
        let forth = self.reach(&heads, &e.way, &nut);
        if !forth.contains(&e.nut) {
            return BTreeSet::new();
        }
        let back = self.reach(&nut, &-e.way, &heads);
        let grip: BTreeSet<usize> = forth.intersection(&back).copied().collect();
        let seated = self.seated(e, (e.screw, e.nut), &e.way, &grip)
            && self.seated(e, (e.nut, e.screw), &-e.way, &grip);
        match seated {
            true => grip,
            false => BTreeSet::new(),
        }
    }

    /// Whether the screw, or its nut, bears on what it presses: over some of the screw's section, and all around its
    /// axis. Of a stud, and of what presses with a point or a cone, nothing is asked.
    fn seated(
        &self,
        e: &Engaged,
        (end, other_end): (usize, usize),
        way: &Vector3<f64>,
        grip: &BTreeSet<usize>,
    ) -> bool {
        let own = self.pairs.get(end).into_iter().flatten();
        let pairs = own.filter_map(|i| self.of.pairs.get(*i));
        let (mut area, mut arms) = (0.0, Vec::new());
        for p in pairs {
            let (other, sign) = if p.a == end { (p.b, 1.0) } else { (p.a, -1.0) };
            if !grip.contains(&other) && other != other_end {
                continue;
            }
            for m in p.meetings.iter().filter(|m| m.touches()) {
                let along = |n: [f64; 3]| Vector3::from(n).dot(way) * sign > ALONG;
                if !m.spots.iter().any(|s| along(s.normal)) {
                    continue;
                }
                if m.kind != Kind::Plane {
                    return true;
                }
                area += m.area_mm2;
                arms.extend(m.spots.iter().map(|s| Vector3::from(s.at) - e.point));
            }
        }
        if arms.is_empty() {
            return true;
        }
        let section = core::f64::consts::FRAC_PI_4 * e.diameter * e.diameter;
        area >= BEARING * section && around(&arms, way)
    }

    /// The parts that some press on, and those that these press on.
    fn reach(
        &mut self,
        from: &BTreeSet<usize>,
        way: &Vector3<f64>,
        stop: &BTreeSet<usize>,
    ) -> BTreeSet<usize> {
        let mut found = BTreeSet::new();
        let mut open: Vec<usize> = from.iter().copied().collect();
        while let Some(part) = open.pop() {
            for next in self.onward(part, way) {
                if !from.contains(&next) && found.insert(next) && !stop.contains(&next) {
                    open.push(next);
                }
            }
        }
        found
    }

    fn onward(&mut self, part: usize, way: &Vector3<f64>) -> Vec<usize> {
        let key = (
            part,
            <[f64; 3]>::from(*way).map(|x| libm::round(x / SAME_WAY) as i64),
        );
        if let Some(known) = self.known.get(&key) {
            return known.clone();
        }
        let own = self.pairs.get(part).into_iter().flatten();
        let pairs = own.filter_map(|i| self.of.pairs.get(*i));
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
        let next: Vec<usize> = next.collect();
        self.known.insert(key, next.clone());
        next
    }
}
