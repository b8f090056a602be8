//! Freedom against what is known otherwise.

mod drive;
mod gears;
mod invariance;
mod large;
mod linkages;
mod mates;
mod merging;
mod parts;
mod timing;

use super::{Axis, Body, Freedom, Hold, Lasting, Link, System, analyse};
use crate::frame::{Frame, Placement};
use crate::mates::Twist;

pub(super) const TURN: [f64; 6] = [0.0, 0.0, 1.0, 0.0, 0.0, 0.0];
pub(super) const SLIDE: [f64; 6] = [0.0, 0.0, 0.0, 0.0, 0.0, 1.0];
pub(super) const X: [f64; 3] = [1.0, 0.0, 0.0];
pub(super) const Y: [f64; 3] = [0.0, 1.0, 0.0];
pub(super) const Z: [f64; 3] = [0.0, 0.0, 1.0];

/// Bodies `0`, `1`, ... of which the first stands still, and what joins them.
#[derive(Default)]
pub(super) struct Maker(pub(super) System);

impl Maker {
    pub(super) fn new(bodies: &[&str]) -> Self {
        let body = |n: &&str| Body {
            name: (*n).to_owned(),
            at: [0.0; 3],
            spin: None,
        };
        Self(System {
            bodies: bodies.iter().map(body).collect(),
            links: Vec::new(),
            root: Some(0),
        })
    }

    pub(super) fn link(
        mut self,
        a: usize,
        b: usize,
        at: [f64; 3],
        z: [f64; 3],
        hold: Hold,
    ) -> Self {
        let z = nalgebra::Vector3::from(z).normalize();
        let x = if z.x.abs() < 0.9 {
            nalgebra::Vector3::x()
        } else {
            nalgebra::Vector3::y()
        };
        let x = (x - z * z.dot(&x)).normalize();
        let frame = Frame::new(at, z.into(), x.into())
            .unwrap()
            .placement()
            .unwrap();
        self.0.links.push(Link {
            name: format!("j{}", self.0.links.len()),
            base: a,
            incoming: b,
            frame,
            hold,
        });
        self
    }

    /// A joint with these free twists about an axis.
    pub(super) fn free(
        self,
        a: usize,
        b: usize,
        at: [f64; 3],
        z: [f64; 3],
        twists: &[[f64; 6]],
    ) -> Self {
        let twists = twists.iter().map(|t| Twist(*t)).collect();
        self.link(a, b, at, z, Hold::Free(twists))
    }

    pub(super) fn turn(self, a: usize, b: usize, at: [f64; 3], z: [f64; 3]) -> Self {
        self.free(a, b, at, z, &[TURN])
    }

    pub(super) fn slide(self, a: usize, b: usize, at: [f64; 3], z: [f64; 3]) -> Self {
        self.free(a, b, at, z, &[SLIDE])
    }

    pub(super) fn ball(self, a: usize, b: usize, at: [f64; 3]) -> Self {
        let turns: Vec<[f64; 6]> = (0..3)
            .map(|i| core::array::from_fn(|k| f64::from(u8::from(k == i))))
            .collect();
        self.free(a, b, at, Z, &turns)
    }

    /// Teeth between two gears about z.
    pub(super) fn mesh(self, a: usize, b: usize, from: [f64; 3], to: [f64; 3], ratio: f64) -> Self {
        self.link(
            a,
            b,
            from,
            Z,
            Hold::Gears {
                incoming_axis: to,
                ratio,
                slope: 0.0,
            },
        )
    }

    pub(super) fn round(mut self, body: usize, point: [f64; 3], direction: [f64; 3]) -> Self {
        self.0.bodies[body].spin = Some(Axis { point, direction });
        self
    }

    pub(super) fn solve(&self) -> Freedom {
        analyse(&self.0)
    }
}

/// Mobility, redundant constraints, lasting mobility.
pub(super) fn numbers(f: &Freedom) -> (usize, usize, usize) {
    let redundant = f.redundant.iter().map(|r| r.count).sum();
    (f.mobility.unwrap(), redundant, f.lasting_mobility.unwrap())
}

pub(super) fn lasting(f: &Freedom) -> Vec<Lasting> {
    f.motions.iter().map(|m| m.lasting).collect()
}

pub(super) fn placement_of(p: [f64; 3], axis: [f64; 3], deg: f64) -> Placement {
    Placement::translation(p[0], p[1], p[2])
        * Placement::rotation_about([0.0; 3], axis, deg).unwrap()
}
