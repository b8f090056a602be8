//! What one mate demands: rows on the twists of its two bodies, and residuals of finite displacements.
//!
//! All lengths here are shares of a characteristic length, so that turns and slides compare.

use nalgebra::{Vector3, Vector6};

use super::linear::complement;
use super::rigid::{Rigid, angular, linear, stack};
use super::{Hold, Link};

/// A link in units of the characteristic length, about the island's middle.
#[derive(Debug, Clone)]
pub(super) struct Scaled {
    pub(super) frame: Rigid,
    pub(super) hold: ScaledHold,
}

#[derive(Debug, Clone)]
pub(super) enum ScaledHold {
    /// Free twists in the frame, and the orthonormal wrenches that hold the rest.
    Free {
        free: Vec<Vector6<f64>>,
        held: Vec<Vector6<f64>>,
    },
    /// A point on the incoming gear's axis, the ratio, and the slope of the teeth.
    Gears {
        incoming: Vector3<f64>,
        ratio: f64,
        slope: f64,
    },
}

impl Scaled {
    pub(super) fn new(link: &Link, middle: &Vector3<f64>, length: f64) -> Self {
        let scale = |p: Vector3<f64>| (p - middle) / length;
        let mut frame = Rigid::from(&link.frame);
        frame.translation = scale(frame.translation);
        let hold = match &link.hold {
            Hold::Free(twists) => {
                let free: Vec<Vector6<f64>> = twists
                    .iter()
                    .map(|t| {
                        let t = Vector6::from(t.0);
                        let t = stack(&angular(&t), &(linear(&t) / length));
                        // At a rate of 1 it turns by a radian or goes by the characteristic length.
                        let turn = angular(&t).norm();
                        t / if turn > 0.0 { turn } else { t.norm() }
                    })
                    .collect();
                let held = complement(&free);
                ScaledHold::Free { free, held }
            }
            Hold::Gears {
                incoming_axis,
                ratio,
                slope,
            } => ScaledHold::Gears {
                incoming: scale((*incoming_axis).into()),
                ratio: *ratio,
                slope: *slope,
            },
        };
        Self { frame, hold }
    }

    /// How many rows it has.
    pub(super) fn rows(&self) -> usize {
        match &self.hold {
            ScaledHold::Free { held, .. } => held.len(),
            ScaledHold::Gears { .. } => 1,
        }
    }

    /// The rows on the incoming body's twist; those on the base body's are the same with the other sign.
    /// The bodies have moved from where they were placed.
    pub(super) fn jacobian(&self, base: &Rigid, incoming: &Rigid) -> Vec<Vector6<f64>> {
        let frame = base.after(&self.frame);
        match &self.hold {
            ScaledHold::Free { held, .. } => held.iter().map(|w| wrench(&frame, w)).collect(),
            ScaledHold::Gears {
                incoming: axis,
                ratio,
                slope,
            } => {
                // The teeth do not let the two gears pass each other at the pitch point P, where the pitch
                // circles roll: along the common tangent t, and for helical teeth across their slope, both
                // gears have the same speed there, whatever carries their axes. From O_b towards O_c, at
                // the distance a, P lies at x with x = k (x - a), k being the ratio of the two turns.
                let at = frame.inverse().point(&incoming.point(axis));
                let (dir, _, x) = pitch_point(&at, *ratio);
                let t = Vector3::z().cross(&dir) * sign(x);
                let n = t - Vector3::z() * *slope;
                let w = stack(&(dir * x).cross(&n), &n);
                vec![wrench(&frame, &w)]
            }
        }
    }

    /// How far the link is from holding after the bodies moved. Its freedom being that of a group of motions,
    /// a displacement is allowed where its logarithm is.
    pub(super) fn residual(&self, base: &Rigid, incoming: &Rigid) -> Vec<f64> {
        let back = base.after(&self.frame).inverse();
        let moved = back.after(&incoming.after(&self.frame));
        match &self.hold {
            ScaledHold::Free { held, .. } => {
                let log = moved.log();
                held.iter().map(|w| w.dot(&log)).collect()
            }
            ScaledHold::Gears {
                incoming: axis,
                ratio,
                slope,
            } => {
                // The phase of the mate `gear_mesh`: the incoming gear's turn psi against the base follows
                // the direction theta of its axis by d psi = (1 - k) d theta.
                let was = self.frame.inverse().point(axis);
                let is = back.point(&incoming.point(axis));
                let (_, a, x) = pitch_point(&was, *ratio);
                let r = &moved.rotation;
                let psi = libm::atan2(r.m21 - r.m12, r.m11 + r.m22);
                let theta = libm::atan2(was.x * is.y - was.y * is.x, was.x * is.x + was.y * is.y);
                let along = (x - a) * (psi - (1.0 - ratio) * theta);
                // Where the incoming gear's middle plane stands at the pitch point, also when it tilts.
                let (dir, _, x_now) = pitch_point(&is, *ratio);
                let to = dir * x_now - is;
                let height = is.z - (r.m13 * to.x + r.m23 * to.y) / r.m33;
                vec![sign(x) * along - slope * (height - was.z)]
            }
        }
    }

    /// The same link from where its bodies have come to, which holds there as it did.
    pub(super) fn rebased(&self, base: &Rigid, incoming: &Rigid) -> Self {
        let hold = match &self.hold {
            free @ ScaledHold::Free { .. } => free.clone(),
            ScaledHold::Gears {
                incoming: axis,
                ratio,
                slope,
            } => ScaledHold::Gears {
                incoming: incoming.point(axis),
                ratio: *ratio,
                slope: *slope,
            },
        };
        Self {
            frame: base.after(&self.frame),
            hold,
        }
    }

    /// The link with some of its free twists held too; none where the rest is no group of motions.
    pub(super) fn locked(&self, twists: &[usize]) -> Option<Self> {
        let left = self.free().iter().enumerate();
        let free: Vec<_> = left
            .filter(|(k, _)| !twists.contains(k))
            .map(|(_, t)| *t)
            .collect();
        let locked = Self {
            frame: self.frame,
            hold: ScaledHold::Free {
                held: complement(&free),
                free,
            },
        };
        locked.is_group().then_some(locked)
    }

    /// The axis of a link that leaves one rotation free and nothing else: a point and a direction.
    pub(super) fn hinge(&self) -> Option<(Vector3<f64>, Vector3<f64>)> {
        let [t] = self.free() else {
            return None;
        };
        let (turn, slide) = (angular(t), linear(t));
        let rotates = turn.norm() > 0.0 && turn.dot(&slide).abs() <= 1e-12;
        rotates.then(|| {
            let near = turn.cross(&slide) / turn.norm_squared();
            (
                self.frame.point(&near),
                self.frame.rotation * turn.normalize(),
            )
        })
    }

    /// The free twists.
    pub(super) fn free(&self) -> &[Vector6<f64>] {
        match &self.hold {
            ScaledHold::Free { free, .. } => free,
            ScaledHold::Gears { .. } => &[],
        }
    }

    /// The rates at which the incoming body moves against the base body along the free twists.
    pub(super) fn rates(&self, relative: &Vector6<f64>) -> Vec<f64> {
        let ScaledHold::Free { free, .. } = &self.hold else {
            return Vec::new();
        };
        if free.is_empty() {
            return Vec::new();
        }
        let local = self.frame.inverse().twist(relative);
        let t = nalgebra::OMatrix::<f64, nalgebra::U6, nalgebra::Dyn>::from_columns(free);
        let normal = t.transpose() * &t;
        let right = t.transpose() * local;
        match normal.cholesky() {
            Some(c) => c.solve(&right).iter().copied().collect(),
            None => vec![0.0; free.len()],
        }
    }

    /// Whether the free twists are those of a group: the product of any two of them is one again. Only then
    /// do they say what the joint allows away from the pose.
    pub(super) fn is_group(&self) -> bool {
        let ScaledHold::Free { free, held } = &self.hold else {
            return true;
        };
        let closed = |a: &Vector6<f64>, b: &Vector6<f64>| {
            let turn = angular(a).cross(&angular(b));
            let slide = angular(a).cross(&linear(b)) - angular(b).cross(&linear(a));
            let product = stack(&turn, &slide);
            held.iter()
                .all(|w| w.dot(&product).abs() <= 1e-9 * a.norm() * b.norm())
        };
        free.iter().all(|a| free.iter().all(|b| closed(a, b)))
    }
}

/// The direction of the centre line, the centre distance, and where the pitch point is on it.
pub(super) fn pitch_point(at: &Vector3<f64>, ratio: f64) -> (Vector3<f64>, f64, f64) {
    let a = libm::hypot(at.x, at.y);
    (
        Vector3::new(at.x / a, at.y / a, 0.0),
        a,
        a * ratio / (ratio - 1.0),
    )
}

pub(super) fn sign(x: f64) -> f64 {
    if x < 0.0 { -1.0 } else { 1.0 }
}

/// A row on twists in a frame as a row on twists outside: `w . F^-1(t)`.
fn wrench(frame: &Rigid, w: &Vector6<f64>) -> Vector6<f64> {
    // F^-1(t) = (R^T turn, R^T (slide - p x turn)), hence w . F^-1(t) = (R m + p x R f) . turn + R f . slide.
    let force = frame.rotation * linear(w);
    let moment = frame.rotation * angular(w) + frame.translation.cross(&force);
    stack(&moment, &force)
}
