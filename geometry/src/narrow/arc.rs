//! Arcs of circles, and how near and how far they reach.

use super::patch::{V, across};

/// A part of a circle: the unit directions within half of its sweep from its middle.
#[derive(Debug, Clone, Copy)]
pub(super) struct Arc {
    axis: V,
    /// Unit direction of its middle, across the axis.
    middle: V,
    /// Half of its sweep, in radians.
    half: f64,
}

/// By how much arcs are taken wider than they were found, in radians.
const WIDER: f64 = 1e-9;

impl Arc {
    pub(super) fn whole(axis: &V) -> Self {
        Self {
            axis: *axis,
            middle: V::zeros(),
            half: core::f64::consts::PI,
        }
    }

    /// The arc from a point on, by the right-hand rule.
    pub(super) fn swept(center: &V, axis: &V, start: &V, sweep: f64) -> Option<Self> {
        if sweep >= core::f64::consts::TAU - 1e-6 {
            return Some(Self::whole(axis));
        }
        let first = across(&(start - center), axis).try_normalize(1e-12)?;
        let (sin, cos) = libm::sincos(sweep / 2.0);
        Some(Self {
            axis: *axis,
            middle: first * cos + axis.cross(&first) * sin,
            half: sweep / 2.0 + WIDER,
        })
    }

    /// The arc that some points of a cylinder span, which lie within half a turn.
    pub(super) fn of(origin: &V, axis: &V, corners: &[V; 3]) -> Option<Self> {
        let units: Option<Vec<V>> = corners
            .iter()
            .map(|c| across(&(c - origin), axis).try_normalize(1e-12))
            .collect();
        let units = units?;
        // The widest two of the three stand at the ends.
        let mut best: Option<(f64, V)> = None;
        for (i, a) in units.iter().enumerate() {
            for b in units.iter().skip(i + 1) {
                let angle = libm::atan2(a.cross(b).norm(), a.dot(b));
                let middle = (a + b).try_normalize(1e-6)?;
                if best.as_ref().is_none_or(|(most, _)| angle > *most) {
                    best = Some((angle, middle));
                }
            }
        }
        let (angle, middle) = best?;
        // More than a quarter turn in one triangle leaves too much open.
        (angle < core::f64::consts::FRAC_PI_2).then_some(Self {
            axis: *axis,
            middle,
            half: angle / 2.0 + WIDER,
        })
    }

    pub(super) fn same(&self, other: &Self) -> bool {
        (self.half - other.half).abs() <= 1e-6 && (self.middle - other.middle).norm() <= 1e-6
    }

    fn is_whole(&self) -> bool {
        self.half >= core::f64::consts::PI
    }

    /// The angle of a direction from the arc's middle.
    fn angle(&self, direction: &V) -> f64 {
        let flat = across(direction, &self.axis);
        libm::atan2(self.middle.cross(&flat).norm(), self.middle.dot(&flat))
    }

    /// The smallest value of `direction . u` over the unit directions u of the arc.
    pub(super) fn lowest(&self, direction: &V) -> f64 {
        let reach = across(direction, &self.axis).norm();
        if self.is_whole() {
            return -reach;
        }
        let angle = self.angle(direction);
        // Opposite to the direction where the arc has it, else at its far end.
        match angle + self.half >= core::f64::consts::PI {
            true => -reach,
            false => reach * libm::cos(angle + self.half),
        }
    }

    /// The smallest distance of the arc's points at a radius from a point across the axis.
    pub(super) fn nearest(&self, radius: f64, point: &V) -> f64 {
        let out = point.norm();
        if self.is_whole() || self.angle(point) <= self.half {
            return (out - radius).abs();
        }
        chord(out, radius, self.angle(point) - self.half)
    }

    /// The largest one.
    pub(super) fn farthest(&self, radius: f64, point: &V) -> f64 {
        let out = point.norm();
        if self.is_whole() || self.angle(point) + self.half >= core::f64::consts::PI {
            return out + radius;
        }
        chord(out, radius, self.angle(point) + self.half)
    }
}

/// The distance of two points at radii from a centre, with an angle between them.
fn chord(a: f64, b: f64, angle: f64) -> f64 {
    let half = libm::sin(angle / 2.0);
    // The law of cosines, in the form that keeps its digits for small angles.
    libm::sqrt((a - b) * (a - b) + 4.0 * a * b * half * half)
}
