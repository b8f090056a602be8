//! Rows on the twists of bodies, in one scale for turns and slides.

use nalgebra::{Vector3, Vector6};

type V = Vector3<f64>;

/// Where twists are taken and in which unit turns compare with slides.
#[derive(Debug, Clone, Copy)]
pub struct Rows {
    /// The point whose speed a twist's linear part is, in mm.
    pub middle: V,
    /// A turn by one radian counts as a slide by so many mm.
    pub length: f64,
}

impl Rows {
    /// The row of the speed along a direction at a point: angular part, then linear part.
    #[must_use]
    pub fn along(&self, at: &V, direction: &V) -> Vector6<f64> {
        let arm = (at - self.middle) / self.length;
        let turn = arm.cross(direction);
        Vector6::new(
            turn.x,
            turn.y,
            turn.z,
            direction.x,
            direction.y,
            direction.z,
        )
    }

    /// The row of the turning speed about a direction.
    #[must_use]
    pub fn about(direction: &V) -> Vector6<f64> {
        Vector6::new(direction.x, direction.y, direction.z, 0.0, 0.0, 0.0)
    }

    /// The twist of a slide.
    #[must_use]
    pub fn slide(direction: &V) -> Vector6<f64> {
        Vector6::new(0.0, 0.0, 0.0, direction.x, direction.y, direction.z)
    }

    /// The twist of a turn about a line.
    #[must_use]
    pub fn turn(&self, point: &V, direction: &V) -> Vector6<f64> {
        let speed = direction.cross(&((self.middle - point) / self.length));
        Vector6::new(
            direction.x,
            direction.y,
            direction.z,
            speed.x,
            speed.y,
            speed.z,
        )
    }
}
