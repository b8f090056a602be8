//! Right-handed frames and rigid placements.

use nalgebra::{Matrix3, Vector3};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::angle::sin_cos_deg;

/// How far a stated direction may be from unit length, and the two directions of a frame from a
/// right angle, before the frame is refused.
pub const DIRECTION_TOLERANCE: f64 = 1e-9;

/// A frame as it is written down: origin in mm, directions `x` and `z`; `y` is `z` cross `x`.
///
/// Both directions are stated, never derived: a derived x on an oblique normal points where nobody expects.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Frame {
    /// Origin in mm.
    pub origin: [f64; 3],
    /// Unit x direction, at a right angle to `z`.
    pub x: [f64; 3],
    /// Unit z direction.
    pub z: [f64; 3],
}

/// Why three numbers do not make a frame.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FrameError {
    /// A number is NaN or infinite.
    NotFinite,
    /// `x` or `z` has no length.
    NoDirection,
    /// `x` and `z` are not at a right angle.
    NotOrthogonal,
}

impl core::fmt::Display for FrameError {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str(match self {
            Self::NotFinite => "a number of the frame is not finite",
            Self::NoDirection => "a direction of the frame has no length",
            Self::NotOrthogonal => "the x direction is not at a right angle to the z direction",
        })
    }
}

impl Frame {
    /// The frame at the origin with the world's axes.
    pub const WORLD: Self = Self {
        origin: [0.0; 3],
        x: [1.0, 0.0, 0.0],
        z: [0.0, 0.0, 1.0],
    };

    /// A frame from an origin, a z direction and an x direction of any length.
    ///
    /// Directions along an axis stay exact; others are scaled to unit length.
    ///
    /// # Errors
    /// [`FrameError`] for numbers that are not finite, directions of no length or not at a right angle.
    pub fn new(origin: [f64; 3], z: [f64; 3], x: [f64; 3]) -> Result<Self, FrameError> {
        if origin.iter().chain(&z).chain(&x).any(|n| !n.is_finite()) {
            return Err(FrameError::NotFinite);
        }
        let (z, x) = (unit(z)?, unit(x)?);
        if z.dot(&x).abs() > DIRECTION_TOLERANCE {
            return Err(FrameError::NotOrthogonal);
        }
        Ok(Self {
            origin,
            x: x.into(),
            z: z.into(),
        })
    }

    /// The placement that carries the world's axes onto this frame.
    ///
    /// # Errors
    /// As [`Frame::new`]: a frame read from a file may be anything.
    pub fn placement(&self) -> Result<Placement, FrameError> {
        let frame = Self::new(self.origin, self.z, self.x)?;
        let (x, z) = (Vector3::from(frame.x), Vector3::from(frame.z));
        // One Gram-Schmidt step takes the last digits of a slanted x out of the rotation.
        let x = if z.dot(&x) == 0.0 {
            x
        } else {
            (x - z * z.dot(&x)).normalize()
        };
        Ok(Placement {
            rotation: Matrix3::from_columns(&[x, z.cross(&x), z]),
            translation: frame.origin.into(),
        })
    }
}

fn unit(v: [f64; 3]) -> Result<Vector3<f64>, FrameError> {
    let v = Vector3::from(v);
    let largest = v.amax();
    if largest == 0.0 {
        return Err(FrameError::NoDirection);
    }
    // Scaling by the largest component first avoids overflow and keeps axis directions exact.
    let v = v / largest;
    let norm = v.norm();
    Ok(if norm == 1.0 { v } else { v / norm })
}

/// A rigid motion: rotation then translation. Maps part coordinates to world coordinates.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(from = "Rows", into = "Rows")]
pub struct Placement {
    rotation: Matrix3<f64>,
    translation: Vector3<f64>,
}

/// The wire form of a placement: the three rows of the 3 x 4 matrix `[R | t]`, translation in mm.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Rows(pub [[f64; 4]; 3]);

impl From<Placement> for Rows {
    fn from(p: Placement) -> Self {
        let (r, t) = (&p.rotation, &p.translation);
        // Adding 0.0 turns -0.0 into 0.0, which would otherwise print differently.
        Self([
            [r.m11 + 0.0, r.m12 + 0.0, r.m13 + 0.0, t.x + 0.0],
            [r.m21 + 0.0, r.m22 + 0.0, r.m23 + 0.0, t.y + 0.0],
            [r.m31 + 0.0, r.m32 + 0.0, r.m33 + 0.0, t.z + 0.0],
        ])
    }
}

impl From<Rows> for Placement {
    fn from(Rows([a, b, c]): Rows) -> Self {
        Self {
            rotation: Matrix3::new(a[0], a[1], a[2], b[0], b[1], b[2], c[0], c[1], c[2]),
            translation: Vector3::new(a[3], b[3], c[3]),
        }
    }
}

impl Default for Placement {
    fn default() -> Self {
        Self::IDENTITY
    }
}

impl Placement {
    /// The placement that moves nothing.
    pub const IDENTITY: Self = Self {
        rotation: Matrix3::new(1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0),
        translation: Vector3::new(0.0, 0.0, 0.0),
    };

    /// A translation in mm.
    #[must_use]
    pub fn translation(x: f64, y: f64, z: f64) -> Self {
        Self {
            translation: Vector3::new(x, y, z),
            ..Self::IDENTITY
        }
    }

    /// A rotation about the x axis, in degrees; exact at multiples of 90.
    #[must_use]
    pub fn rotation_x(deg: f64) -> Self {
        let (s, c) = sin_cos_deg(deg);
        let rotation = Matrix3::new(1.0, 0.0, 0.0, 0.0, c, -s, 0.0, s, c);
        Self {
            rotation,
            ..Self::IDENTITY
        }
    }

    /// A rotation about the z axis, in degrees; exact at multiples of 90.
    #[must_use]
    pub fn rotation_z(deg: f64) -> Self {
        let (s, c) = sin_cos_deg(deg);
        let rotation = Matrix3::new(c, -s, 0.0, s, c, 0.0, 0.0, 0.0, 1.0);
        Self {
            rotation,
            ..Self::IDENTITY
        }
    }

    /// A rotation about an axis through a point, in degrees (Rodrigues' formula).
    ///
    /// # Errors
    /// [`FrameError`] when the axis has no length or a number is not finite.
    pub fn rotation_about(point: [f64; 3], axis: [f64; 3], deg: f64) -> Result<Self, FrameError> {
        if point.iter().chain(&axis).any(|n| !n.is_finite()) || !deg.is_finite() {
            return Err(FrameError::NotFinite);
        }
        let axis = unit(axis)?;
        let (s, c) = sin_cos_deg(deg);
        let k = axis.cross_matrix();
        let rotation = Matrix3::identity() + k * s + k * k * (1.0 - c);
        let point = Vector3::from(point);
        Ok(Self {
            rotation,
            translation: point - rotation * point,
        })
    }

    /// The placement that does `inner` first, then `self`.
    #[must_use]
    pub fn then_inner(&self, inner: &Self) -> Self {
        Self {
            rotation: self.rotation * inner.rotation,
            translation: self.rotation * inner.translation + self.translation,
        }
    }

    /// The placement that undoes this one (the transpose: rotations stay exact).
    #[must_use]
    pub fn inverse(&self) -> Self {
        let rotation = self.rotation.transpose();
        Self {
            rotation,
            translation: -(rotation * self.translation),
        }
    }

    /// A point carried by this placement.
    #[must_use]
    pub fn point(&self, p: [f64; 3]) -> [f64; 3] {
        (self.rotation * Vector3::from(p) + self.translation).into()
    }

    /// A direction carried by this placement.
    #[must_use]
    pub fn direction(&self, d: [f64; 3]) -> [f64; 3] {
        (self.rotation * Vector3::from(d)).into()
    }

    /// A frame carried by this placement.
    #[must_use]
    pub fn frame(&self, f: &Frame) -> Frame {
        Frame {
            origin: self.point(f.origin),
            x: self.direction(f.x),
            z: self.direction(f.z),
        }
    }

    /// The origin of the carried frame, in mm.
    #[must_use]
    pub fn origin(&self) -> Vector3<f64> {
        self.translation
    }

    /// The rotation.
    #[must_use]
    pub fn rotation(&self) -> &Matrix3<f64> {
        &self.rotation
    }

    /// The x, y and z direction of the carried frame.
    #[must_use]
    pub fn axes(&self) -> [Vector3<f64>; 3] {
        [0, 1, 2].map(|i| self.rotation.column(i).into_owned())
    }

    /// How far the rotation is from orthonormal: the largest entry of `R^T R - 1`.
    #[must_use]
    pub fn orthonormality_error(&self) -> f64 {
        (self.rotation.transpose() * self.rotation - Matrix3::identity()).amax()
    }
}

impl core::ops::Mul for Placement {
    type Output = Self;
    fn mul(self, inner: Self) -> Self {
        self.then_inner(&inner)
    }
}

#[cfg(test)]
mod tests {
    use super::{Frame, FrameError, Placement};
    use proptest::prelude::*;

    #[test]
    fn frames_along_axes_are_exact() {
        let f = Frame::new([1.0, 2.0, 3.0], [0.0, -7.0, 0.0], [0.0, 0.0, 0.1]).unwrap();
        assert_eq!(f.z, [0.0, -1.0, 0.0]);
        assert_eq!(f.x, [0.0, 0.0, 1.0]);
        // y = z cross x = -Y cross Z = -X.
        assert_eq!(
            f.placement().unwrap().axes()[1].as_slice(),
            &[-1.0, 0.0, 0.0]
        );
    }

    #[test]
    fn bad_frames_are_refused() {
        let z = [0.0, 0.0, 1.0];
        assert_eq!(
            Frame::new([0.0; 3], z, [0.0; 3]),
            Err(FrameError::NoDirection)
        );
        assert_eq!(
            Frame::new([0.0; 3], z, [1.0, 0.0, 1.0]),
            Err(FrameError::NotOrthogonal)
        );
        assert_eq!(
            Frame::new([f64::NAN, 0.0, 0.0], z, z),
            Err(FrameError::NotFinite)
        );
    }

    proptest! {
        #[test]
        fn placements_compose_and_invert(
            o in prop::array::uniform3(-1e3..1e3f64),
            axis in prop::array::uniform3(0.1..1.0f64),
            deg in -720.0..720.0f64,
            p in prop::array::uniform3(-1e3..1e3f64),
        ) {
            let t = Placement::rotation_about(o, axis, deg).unwrap()
                * Placement::translation(o[0], o[1], o[2]);
            prop_assert!(t.orthonormality_error() < 1e-12);
            let q = t.inverse().point(t.point(p));
            for i in 0..3 {
                prop_assert!((p[i] - q[i]).abs() < 1e-9);
            }
        }
    }
}
