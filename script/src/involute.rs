//! The outline of spur gears with involute teeth, as lines and arcs.
//!
//! The involute of the base circle `r_b`, unrolled by the angle `t`, is at the radius
//! `r_b sqrt(1 + t^2)` and the polar angle `t - atan t`; its normal touches the base circle.
//! Proportions are those of the basic rack of ISO 53, profile A: addendum 1 m, dedendum 1.25 m.
//!
//! Two simplifications, both on the side of less material than a generated gear has:
//! - Flanks are circular arcs through points of the involute. They stay within
//!   [`FLANK_TOLERANCE_MM`] of it and never on its outside, so that two gears without backlash do not
//!   overlap. Cylinders are exact and quick in the kernel, and free-form faces are neither.
//! - Below the base circle (or the root circle, where that is larger) the flank goes on as a radial
//!   line to the root circle, with a sharp corner. The rounded root of ISO 53 (0.38 m on the rack)
//!   would be a trochoid; it lies outside of the radial line wherever there is no undercut.

use core::f64::consts::PI;

use assemcad_model::angle::sin_cos_deg;
use assemcad_model::language::{Outline, Segment};

/// How far a flank is at most inside the involute, measured along the normal, in mm.
pub(crate) const FLANK_TOLERANCE_MM: f64 = 0.5e-3;

/// Addendum and dedendum of ISO 53, profile A, in modules.
const ADDENDUM: f64 = 1.0;
const DEDENDUM: f64 = 1.25;

/// Shorter lines are left out, in mm: the kernel refuses them.
const SHORTEST_MM: f64 = 1e-5;

/// Arcs about the axis that bulge less are lines, in mm: the kernel takes them for such.
const FLATTEST_MM: f64 = 1e-5;

/// More arcs in a flank than any gear within reason needs.
const MOST_ARCS: f64 = 200.0;

/// The teeth of a spur gear. Lengths in mm.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Toothing {
    pub(crate) module: f64,
    pub(crate) teeth: u32,
    pub(crate) pressure_angle_deg: f64,
    /// Profile shift in modules; positive away from the axis, also of internal teeth.
    pub(crate) profile_shift: f64,
    /// What every tooth is thinner, along the pitch circle.
    pub(crate) thinning: f64,
    /// Teeth that point inwards: the outline is that of the hole.
    pub(crate) internal: bool,
}

/// One flank: an involute between two unrolled angles, and its arcs.
#[derive(Debug, Clone, Copy)]
struct Flank {
    base_radius: f64,
    /// Polar angle from the middle of what the outline encloses (a tooth, or the gap between internal
    /// teeth) to the foot of the involute, which points at that middle.
    half_angle: f64,
    /// Unrolled angles at the inner and the outer end.
    from: f64,
    to: f64,
    arcs: u32,
}

impl Flank {
    /// The flank between two radii, moved into the material by what its arcs may be off.
    fn new(base_radius: f64, half_angle: f64, inner: f64, outer: f64, internal: bool) -> Self {
        let unrolled = |radius: f64| {
            let over = radius / base_radius;
            libm::sqrt((over * over - 1.0).max(0.0))
        };
        let (from, to) = (unrolled(inner), unrolled(outer));
        // A circle through the points at t, t + h/2 and t + h is off by less than r_b h^3 / 100,
        // most at t = 0: there the involute is (r_b t^2 / 2, r_b t^3 / 3) to the lowest order with its
        // tangent along the first axis, the circle is a parabola, and with the one through the three
        // points the difference is r_b t^2 (t - h/2) (t - h) / (4.5 h): at most r_b h^3 / 116. Elsewhere
        // (a curvature of 1 / (r_b t) over a length of r_b t h) it is r_b h^3 / 125. The rest is for
        // higher orders; the test measures it. No t in the bound: equal steps are the best.
        let step = libm::cbrt(FLANK_TOLERANCE_MM / 2.0 * 100.0 / base_radius);
        let arcs = libm::ceil((to - from) / step).clamp(1.0, MOST_ARCS);
        let width = (to - from) / arcs;
        let off = base_radius * width * width * width / 100.0;
        // An involute that is turned about the axis by an angle has moved along all its normals by
        // r_b times that angle.
        let inwards = if internal { off } else { -off };
        Self {
            base_radius,
            half_angle: half_angle + inwards / base_radius,
            from,
            to,
            arcs: arcs as u32,
        }
    }

    /// The point after `n` halves of arcs, on the side of positive angles.
    fn point(&self, n: u32) -> [f64; 2] {
        let t = if n == 2 * self.arcs {
            self.to
        } else {
            self.from + (self.to - self.from) * f64::from(n) / f64::from(2 * self.arcs)
        };
        let radius = self.base_radius * libm::sqrt(1.0 + t * t);
        let (sin, cos) = libm::sincos(self.half_angle - (t - libm::atan(t)));
        [radius * cos, radius * sin]
    }
}

/// `inv x = tan x - x`.
fn involute(angle: f64) -> f64 {
    libm::tan(angle) - angle
}

impl Toothing {
    /// The outline, counter-clockwise. The middle of a tooth is on +x; of an external gear the outline
    /// bounds the gear, of an internal one its hole.
    pub(crate) fn outline(&self) -> Result<Outline, String> {
        let (alpha, z, m) = (
            self.pressure_angle_deg * PI / 180.0,
            f64::from(self.teeth),
            self.module,
        );
        let pitch_radius = m * z / 2.0;
        let base_radius = pitch_radius * libm::cos(alpha);
        let (below, above, widening) = if self.internal {
            (ADDENDUM, DEDENDUM, self.thinning)
        } else {
            (DEDENDUM, ADDENDUM, -self.thinning)
        };
        let inner = pitch_radius - m * (below - self.profile_shift);
        let outer = pitch_radius + m * (above + self.profile_shift);
        if inner < SHORTEST_MM {
            return Err("the root circle is smaller than nothing".to_owned());
        }
        if self.internal && inner < base_radius {
            return Err(format!(
                "the tips of the internal teeth (radius {inner}) reach below the base circle (radius \
                 {base_radius}): take more teeth"
            ));
        }
        // The thickness at the pitch circle of what is enclosed: its angle grows towards the base
        // circle by the involute function.
        let thickness = m * (PI / 2.0 + 2.0 * self.profile_shift * libm::tan(alpha)) + widening;
        let half_angle = thickness / (2.0 * pitch_radius) + involute(alpha);
        if outer <= base_radius {
            return Err("the outer circle lies below the base circle".to_owned());
        }
        let foot = if base_radius - inner < SHORTEST_MM {
            inner
        } else {
            base_radius
        };
        let flank = Flank::new(
            base_radius,
            half_angle,
            foot.max(inner),
            outer,
            self.internal,
        );
        let last = 2 * flank.arcs;
        let low = flank.point(0);
        let tip = flank.point(last);
        if tip[1] < SHORTEST_MM {
            return Err(
                "the teeth are pointed: their flanks meet below the outer circle".to_owned(),
            );
        }
        let root_angle = libm::atan2(low[1], low[0]);
        if (PI / z - root_angle) * inner < SHORTEST_MM {
            return Err("the flanks of neighbouring teeth meet above the root circle".to_owned());
        }
        let root = if foot > inner {
            let scale = inner / libm::hypot(low[0], low[1]);
            Some([low[0] * scale, low[1] * scale])
        } else {
            None
        };

        // The pieces of what is enclosed about +x, from one root to the other.
        let mirrored = |[x, y]: [f64; 2]| [x, -y];
        let first = mirrored(root.unwrap_or(low));
        let mut pieces = Vec::new();
        if root.is_some() {
            pieces.push((None, mirrored(low)));
        }
        for n in 0..flank.arcs {
            let (via, to) = (flank.point(2 * n + 1), flank.point(2 * n + 2));
            pieces.push((Some(mirrored(via)), mirrored(to)));
        }
        let bulge = |half: f64| outer * half * half / 2.0;
        let round = bulge(libm::atan2(tip[1], tip[0])) >= FLATTEST_MM;
        pieces.push((round.then_some([outer, 0.0]), tip));
        for n in (0..flank.arcs).rev() {
            pieces.push((Some(flank.point(2 * n + 1)), flank.point(2 * n)));
        }
        if let Some(root) = root {
            pieces.push((None, root));
        }
        let round = bulge(PI / z - root_angle) >= FLATTEST_MM;

        // Of internal teeth the outline encloses the gaps, and the first one is half a pitch on.
        let offset = if self.internal { 0.5 } else { 0.0 };
        let turn = |teeth: f64| sin_cos_deg(360.0 * (teeth + offset) / z);
        let turned =
            |(sin, cos): (f64, f64), [x, y]: [f64; 2]| [x * cos - y * sin, x * sin + y * cos];
        let segment = |via: Option<[f64; 2]>, to: [f64; 2]| match via {
            Some(via) => Segment::Arc { via, to },
            None => Segment::Line { to },
        };
        let mut segments = Vec::new();
        for tooth in 0..self.teeth {
            let by = turn(f64::from(tooth));
            for (via, to) in &pieces {
                segments.push(segment(via.map(|p| turned(by, p)), turned(by, *to)));
            }
            // The very digits of the start where the outline closes.
            let next = turn(f64::from((tooth + 1) % self.teeth));
            let via = turned(turn(f64::from(tooth) + 0.5), [inner, 0.0]);
            segments.push(segment(round.then_some(via), turned(next, first)));
        }
        Ok(Outline {
            start: turned(turn(0.0), first),
            segments,
        })
    }
}

#[cfg(test)]
#[path = "involute_tests.rs"]
mod tests;
