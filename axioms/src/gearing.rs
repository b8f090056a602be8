//! What the checks of gears share: the pairs of an assembly and the geometry of ISO 21771.

use core::f64::consts::PI;

use assemcad_model::angle::sin_cos_deg;
use assemcad_model::frame::Placement;
use assemcad_model::mates::MateType;
use assemcad_model::ports::{Port, PortType};

use crate::facts::{MateFacts, Side};
use crate::geometry::{NEAR_DEG, askew_deg, off_axis_mm};
use crate::indexed::Indexed;
use crate::ruling::About;

/// Within this angle, in degrees, a gear counts as straight.
const STRAIGHT_DEG: f64 = 1e-9;

/// Addendum in modules, ISO 53.
pub(crate) const ADDENDUM: f64 = 1.0;

/// Dedendum in modules, ISO 53 profile A.
pub(crate) const DEDENDUM: f64 = 1.25;

/// What is taken for granted about tips and roots, which a port does not state.
pub(crate) const BASIC_RACK: &str =
    "teeth of the basic rack of ISO 53, profile A: addendum 1 module, dedendum 1.25 modules";

/// A gear as its port states it. Lengths in mm, angles in degrees.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Gear {
    pub(crate) module: f64,
    pub(crate) teeth: f64,
    pub(crate) pressure_deg: f64,
    pub(crate) helix_deg: f64,
    pub(crate) width: f64,
    pub(crate) internal: bool,
    pub(crate) shift: f64,
    pub(crate) thinning: f64,
}

impl Gear {
    pub(crate) fn of(p: &Port) -> Self {
        Self {
            module: p.value("module"),
            teeth: p.value("teeth"),
            pressure_deg: p.value("pressure_angle_deg"),
            helix_deg: p.value("helix_angle_deg"),
            width: p.value("width"),
            internal: p.value("internal") == 1.0,
            shift: p.value("profile_shift"),
            thinning: p.value("thinning"),
        }
    }

    pub(crate) fn straight(&self) -> bool {
        self.helix_deg.abs() <= STRAIGHT_DEG
    }

    pub(crate) fn cos_helix(&self) -> f64 {
        sin_cos_deg(self.helix_deg).1
    }

    /// Transverse pressure angle in radians: `tan(alpha_t) = tan(alpha_n) / cos(beta)`.
    pub(crate) fn transverse(&self) -> f64 {
        let (sin, cos) = sin_cos_deg(self.pressure_deg);
        libm::atan2(sin, cos * self.cos_helix())
    }

    /// Pitch radius `m z / (2 cos beta)`.
    pub(crate) fn pitch_radius(&self) -> f64 {
        self.module * self.teeth / (2.0 * self.cos_helix())
    }

    pub(crate) fn base_radius(&self) -> f64 {
        self.pitch_radius() * libm::cos(self.transverse())
    }

    /// Tip radius: a ring's tips are inside. A shift moves both outward.
    pub(crate) fn tip_radius(&self) -> f64 {
        let sign = if self.internal { -1.0 } else { 1.0 };
        self.pitch_radius() + self.module * (sign * ADDENDUM + self.shift)
    }

    /// Root radius: a ring's roots are outside.
    pub(crate) fn root_radius(&self) -> f64 {
        let sign = if self.internal { -1.0 } else { 1.0 };
        self.pitch_radius() - self.module * (sign * DEDENDUM - self.shift)
    }

    /// Tooth thickness along the pitch circle in the transverse section; a ring's shift thins its teeth.
    pub(crate) fn thickness(&self) -> f64 {
        let (sin, cos) = sin_cos_deg(self.pressure_deg);
        let sign = if self.internal { -1.0 } else { 1.0 };
        let normal = self.module * (PI / 2.0 + sign * 2.0 * self.shift * sin / cos) - self.thinning;
        normal / self.cos_helix()
    }
}

/// `inv(alpha) = tan(alpha) - alpha`.
pub(crate) fn involute(alpha: f64) -> f64 {
    libm::tan(alpha) - alpha
}

/// The angle of an involute function's value, by Newton's steps; none outside of 0 to about 60 degrees.
pub(crate) fn inverse_involute(value: f64) -> Option<f64> {
    if !(0.0..=0.7).contains(&value) {
        return None;
    }
    // From the first term of the series, inv(a) = a^3 / 3 + ...
    let mut a = libm::cbrt(3.0 * value);
    for _ in 0..20 {
        let tan = libm::tan(a);
        if tan == 0.0 {
            return Some(0.0);
        }
        a -= (tan - a - value) / (tan * tan);
    }
    a.is_finite().then_some(a)
}

/// A pair of gears that a mate joins.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Pair<'a> {
    pub(crate) mate: &'a MateFacts,
    pub(crate) base: Side<'a>,
    pub(crate) incoming: Side<'a>,
    pub(crate) a: Gear,
    pub(crate) b: Gear,
    /// The incoming gear seen from the base gear, where both have a place.
    pub(crate) seen: Option<Placement>,
}

/// Every pair of gears that a mate joins.
pub(crate) fn pairs(facts: &Indexed) -> Vec<Pair<'_>> {
    let of = |mate: &'_ MateFacts| -> Option<(Side<'_>, Side<'_>)> {
        let (base, incoming) = facts.sides(mate)?;
        let teeth = base.is(PortType::GearMesh) && incoming.is(PortType::GearMesh);
        teeth.then_some((base, incoming))
    };
    let mut out = Vec::new();
    for mate in &facts.mates {
        if mate.mate_type != MateType::GearMesh {
            continue;
        }
        if let Some((base, incoming)) = of(mate) {
            out.push(Pair {
                mate,
                base,
                incoming,
                a: Gear::of(base.port),
                b: Gear::of(incoming.port),
                seen: base.sees(&incoming),
            });
        }
    }
    out
}

impl Pair<'_> {
    pub(crate) fn about(&self) -> About {
        About {
            parts: vec![self.base.part.id.clone(), self.incoming.part.id.clone()],
            mates: vec![self.mate.id.clone()],
        }
    }

    pub(crate) fn names(&self) -> String {
        format!("'{}' and '{}'", self.base.part.id, self.incoming.part.id)
    }

    /// Whether one of them is a ring.
    pub(crate) fn inside(&self) -> bool {
        self.a.internal || self.b.internal
    }

    /// Pinion and ring, or the pair as it is: the ring comes second.
    pub(crate) fn ring_last(&self) -> (Gear, Gear) {
        if self.a.internal {
            (self.b, self.a)
        } else {
            (self.a, self.b)
        }
    }

    /// Whether the axes are parallel; none where they have no place.
    pub(crate) fn parallel(&self) -> Option<bool> {
        Some(askew_deg(&self.seen?) <= NEAR_DEG)
    }

    /// The distance of parallel axes as placed.
    pub(crate) fn distance(&self) -> Option<f64> {
        let seen = self.seen?;
        (self.parallel()?).then(|| off_axis_mm(&seen))
    }

    /// The distance at which the pitch cylinders touch.
    pub(crate) fn reference_distance(&self) -> f64 {
        let (p, q) = self.ring_last();
        if q.internal {
            q.pitch_radius() - p.pitch_radius()
        } else {
            p.pitch_radius() + q.pitch_radius()
        }
    }

    /// The operating centre distance without play, by ISO 21771:
    /// `inv(alpha_wt) = inv(alpha_t) + 2 tan(alpha_n) (x1 + x2) / (z1 + z2)`, `a = a_0 cos(alpha_t) / cos(alpha_wt)`;
    /// differences (ring less pinion) take the place of the sums where one is a ring.
    pub(crate) fn operating_distance(&self) -> Option<f64> {
        let (p, q) = self.ring_last();
        let sign = if q.internal { -1.0 } else { 1.0 };
        let shift = q.shift + sign * p.shift;
        if shift.abs() < 1e-12 {
            return Some(self.reference_distance());
        }
        let (sin, cos) = sin_cos_deg(p.pressure_deg);
        let t = p.transverse();
        let inv = involute(t) + 2.0 * sin / cos * shift / (q.teeth + sign * p.teeth);
        let w = inverse_involute(inv)?;
        Some(self.reference_distance() * libm::cos(t) / libm::cos(w))
    }

    /// The transverse pressure angle at a centre distance, in radians: `cos(alpha_wt) = a_0 cos(alpha_t) / a`.
    pub(crate) fn working_angle(&self, distance: f64) -> Option<f64> {
        let cos = self.reference_distance() * libm::cos(self.a.transverse()) / distance;
        (cos > 0.0 && cos <= 1.0).then(|| libm::acos(cos))
    }

    /// The play along the working pitch circles at a centre distance, in the transverse section.
    pub(crate) fn circular_play(&self, distance: f64) -> Option<f64> {
        let w = self.working_angle(distance)?;
        let (p, q) = self.ring_last();
        let grown = involute(p.transverse()) - involute(w);
        // Working radii stand to the pitch radii as the base radius to cos(alpha_wt).
        let radius = |g: &Gear| g.base_radius() / libm::cos(w);
        let thick = |g: &Gear, sign: f64| {
            radius(g) * (g.thickness() / g.pitch_radius() + sign * 2.0 * grown)
        };
        let pitch = 2.0 * PI * radius(&p) / p.teeth;
        // A ring's teeth grow thicker outward, its gaps being the teeth of a gear of its size.
        let other = if q.internal { -1.0 } else { 1.0 };
        Some(pitch - thick(&p, 1.0) - thick(&q, other))
    }
}

#[cfg(test)]
mod tests;
