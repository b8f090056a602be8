//! What single links say, for those who hold them against something else.

use nalgebra::Vector3;

use super::link::{Scaled, pitch_point, sign};
use super::rigid::Rigid;
use super::{Hold, Link};

impl Link {
    /// The rows on the incoming body's twist against the base body's which the link holds at zero: angular part,
    /// then the linear part of a point in the world in shares of a length in mm.
    #[must_use]
    pub fn rows(&self, point: [f64; 3], length_mm: f64) -> Vec<[f64; 6]> {
        let scaled = Scaled::new(self, &Vector3::from(point), length_mm);
        let still = Rigid::IDENTITY;
        let rows = scaled.jacobian(&still, &still);
        rows.into_iter().map(Into::into).collect()
    }

    /// Of teeth: the pitch point in the world, in mm, and the direction in which both gears have one speed there.
    #[must_use]
    pub fn pitch(&self) -> Option<([f64; 3], [f64; 3])> {
        let Hold::Gears {
            incoming_axis,
            ratio,
            slope,
        } = &self.hold
        else {
            return None;
        };
        let at = Vector3::from(self.frame.inverse().point(*incoming_axis));
        let (dir, _, x) = pitch_point(&at, *ratio);
        let along = Vector3::z().cross(&dir) * sign(x) - Vector3::z() * *slope;
        let point = self.frame.point((dir * x).into());
        let along = self.frame.direction((along / along.norm()).into());
        Some((point, along))
    }
}
