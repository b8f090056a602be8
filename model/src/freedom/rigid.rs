//! Rigid motions with their exponentials and logarithms.
//!
//! Closed forms of SE(3) as in Murray, Li and Sastry, *A Mathematical Introduction to Robotic Manipulation*
//! (1994), chapter 2 and appendix A.

use nalgebra::{Matrix3, Vector3, Vector6};

use crate::frame::Placement;

/// A rotation, then a translation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Rigid {
    pub(super) rotation: Matrix3<f64>,
    pub(super) translation: Vector3<f64>,
}

/// Below this angle in radians the series stand for the closed forms, which cancel there.
const SMALL: f64 = 1e-4;

impl From<&Placement> for Rigid {
    fn from(p: &Placement) -> Self {
        Self {
            rotation: *p.rotation(),
            translation: p.origin(),
        }
    }
}

impl Rigid {
    pub(super) const IDENTITY: Self = Self {
        rotation: Matrix3::new(1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0),
        translation: Vector3::new(0.0, 0.0, 0.0),
    };

    /// `inner` first, then `self`.
    pub(super) fn after(&self, inner: &Self) -> Self {
        Self {
            rotation: self.rotation * inner.rotation,
            translation: self.rotation * inner.translation + self.translation,
        }
    }

    pub(super) fn inverse(&self) -> Self {
        let rotation = self.rotation.transpose();
        Self {
            rotation,
            translation: -(rotation * self.translation),
        }
    }

    pub(super) fn point(&self, p: &Vector3<f64>) -> Vector3<f64> {
        self.rotation * p + self.translation
    }

    /// A twist in this frame, seen from outside.
    pub(super) fn twist(&self, t: &Vector6<f64>) -> Vector6<f64> {
        let turn = self.rotation * angular(t);
        stack(
            &turn,
            &(self.rotation * linear(t) + self.translation.cross(&turn)),
        )
    }

    /// The motion after unit time at a constant twist.
    pub(super) fn exp(t: &Vector6<f64>) -> Self {
        let (turn, slide) = (angular(t), linear(t));
        let angle = turn.norm();
        let (k, square) = (turn.cross_matrix(), angle * angle);
        let (a, b, c) = if angle < SMALL {
            (
                1.0 - square / 6.0,
                0.5 - square / 24.0,
                1.0 / 6.0 - square / 120.0,
            )
        } else {
            let (s, c) = libm::sincos(angle);
            (
                s / angle,
                (1.0 - c) / square,
                (angle - s) / (square * angle),
            )
        };
        let one = Matrix3::identity();
        Self {
            rotation: one + k * a + k * k * b,
            translation: (one + k * b + k * k * c) * slide,
        }
    }

    /// The twist whose exponential this motion is, for turns below half a turn.
    pub(super) fn log(&self) -> Vector6<f64> {
        let r = &self.rotation;
        let axial = Vector3::new(r.m32 - r.m23, r.m13 - r.m31, r.m21 - r.m12) / 2.0;
        let (sin, cos) = (axial.norm(), (r.trace() - 1.0) / 2.0);
        let angle = libm::atan2(sin, cos);
        let square = angle * angle;
        let (turn, c) = if angle < SMALL {
            (axial * (1.0 + square / 6.0), 1.0 / 12.0 + square / 720.0)
        } else {
            let half = angle * sin / (2.0 * (1.0 - cos));
            (axial * (angle / sin), (1.0 - half) / square)
        };
        let k = turn.cross_matrix();
        let slide = (Matrix3::identity() - k * 0.5 + k * k * c) * self.translation;
        stack(&turn, &slide)
    }
}

pub(super) fn angular(t: &Vector6<f64>) -> Vector3<f64> {
    t.fixed_rows::<3>(0).into_owned()
}

pub(super) fn linear(t: &Vector6<f64>) -> Vector3<f64> {
    t.fixed_rows::<3>(3).into_owned()
}

pub(super) fn stack(turn: &Vector3<f64>, slide: &Vector3<f64>) -> Vector6<f64> {
    Vector6::new(turn.x, turn.y, turn.z, slide.x, slide.y, slide.z)
}
