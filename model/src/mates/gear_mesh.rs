//! `gear_mesh`: two gears on parallel axes, a tooth in a gap. Leaves their rotations coupled.
//!
//! # Centre distance
//!
//! `a = (z1 + z2) m_n / (2 cos beta)` outside, `a = |z1 - z2| m_n / (2 cos beta)` where one is a ring
//! (ISO 21771; profile shifts
//! must cancel: outside their sum, inside their difference is 0). Backlash `j`, measured along the pitch circle in the normal section,
//! opens by moving the axes apart (a pinion in a ring: towards the ring's axis). At the pitch point the two
//! flanks of a tooth stand at the angle `alpha_n` on either side of the centre line, so that a shift `da`
//! along that line frees `da tan(alpha_n)` of arc on each of them: `j = 2 da tan(alpha_n)` and
//! `da = j / (2 tan(alpha_n))`. (First order in `da`; the next term is smaller by `da / a`.)
//!
//! # Phase
//!
//! Seen from the base's axis, the incoming axis is in the direction `theta` from the base port's x, where
//! the base has the middle of a tooth; the incoming gear is turned by `psi` against the base. Let `t` be the
//! counterclockwise tangent of the base at the pitch point and `p` the pitch along the rolling circles,
//! `r = p z / (2 pi)`. All positions along `t` are counted from the pitch point, modulo `p`, angles in turns.
//!
//! Outside, the pitch point is at `theta` of the base and at `theta + 1/2` of the incoming gear, whose
//! counterclockwise tangent there is `-t`. The base's teeth are at `-theta z1 p`, the incoming ones at
//! `-(psi - theta - 1/2) z2 p`. A tooth faces a gap where these differ by half a pitch:
//!
//! `psi = theta + 1/2 + (1/2 + theta z1) / z2`   (modulo `1 / z2`).
//!
//! For `theta = 0` only the parity of `z2` matters: half a turn is a whole number of pitches of `z2` for even
//! `z2` and a half one more for odd. A rule from the sum `z1 + z2`, as it was published, cannot be right: it
//! treats 20 + 21 and 21 + 20 alike.
//!
//! Inside, the pitch point lies in the same direction from both axes and both tangents are `t`. With the ring
//! as base that direction is `theta`: teeth at `-theta z1 p` and `(psi - theta) z2 p`, so
//! `psi = theta + (1/2 - theta z1) / z2`. With the pinion as base the ring's axis is at `theta` and the pitch
//! point on the far side, at `theta + 1/2` of both: `psi = theta + 1/2 + (1/2 - (theta + 1/2) z1) / z2`.
//!
//! The teeth of helical gears turn with the height along `t` by the same `h tan(beta)` (opposite hands outside,
//! equal hands inside), so that the phase of the middle planes holds at every height.

use super::{
    Condition, Contact, Coupling, Freedom, Joint, MateKind, MateType, Overlap, Residual, Twist,
    at_most, no_play, over, within,
};
use crate::angle::{between_deg, sin_cos_deg};
use crate::frame::Placement;
use crate::ports::Port;
use crate::ports::PortType::GearMesh;
use crate::ports::gear_mesh::pitch_radius;

pub(super) static KIND: MateKind = MateKind {
    mate_type: MateType::GearMesh,
    name: "gear_mesh",
    doc: "Sets the incoming gear beside the base gear, its axis parallel and in the direction angle from \
          the base port's x, pitch circles tangent, a tooth in a gap.",
    pairs: &[(GearMesh, GearMesh)],
    options: || {
        vec![
            within(
                "m",
                "normal module that both gears must have; 0 does not check",
                "mm",
                0.0,
                100.0,
            ),
            within(
                "r",
                "ratio that the gears must have, teeth of the incoming by teeth of the base gear; 0 does not check",
                "",
                0.0,
                1000.0,
            ),
            super::degrees(
                "angle_deg",
                "direction of the incoming axis from the base port's x",
            ),
            within(
                "backlash_mm",
                "play along the pitch circle, which widens the centre distance",
                "mm",
                0.0,
                10.0,
            ),
        ]
    },
    relative,
    residual,
    conditions,
    freedom,
    contact: |j| Some(Contact::Flanks(window_deg(j))),
    overlap,
    radial_play: no_play,
};

/// How far a flank may be from its partner beyond the backlash, as a share of the module.
const FLANK_SHARE: f64 = 0.03;

/// How deep flanks may lie in each other, in mm: what the curves that stand for involutes deviate.
const FLANK_MM: f64 = 1e-3;

/// How the two gears lie to each other.
#[derive(Clone, Copy, PartialEq)]
enum Side {
    Outside,
    RingIsBase,
    RingIsIncoming,
}

fn side(j: &Joint<'_>) -> Side {
    if j.base.value("internal") == 1.0 {
        Side::RingIsBase
    } else if j.incoming.value("internal") == 1.0 {
        Side::RingIsIncoming
    } else {
        Side::Outside
    }
}

fn teeth(j: &Joint<'_>) -> (f64, f64) {
    (j.base.value("teeth"), j.incoming.value("teeth"))
}

fn radius(p: &Port) -> f64 {
    pitch_radius(
        p.value("module"),
        p.value("teeth"),
        p.value("helix_angle_deg"),
    )
}

fn centre_distance(j: &Joint<'_>) -> f64 {
    let (sin, cos) = sin_cos_deg(j.base.value("pressure_angle_deg"));
    let wider = j.number("backlash_mm") * cos / (2.0 * sin);
    let (base, incoming) = (radius(j.base), radius(j.incoming));
    match side(j) {
        Side::Outside => base + incoming + wider,
        Side::RingIsBase => base - incoming - wider,
        Side::RingIsIncoming => incoming - base - wider,
    }
}

/// The turn of the incoming gear against the base for a centre line in the direction `theta`, in degrees,
/// from 0 up to a pitch.
fn phase_deg(j: &Joint<'_>, theta: f64) -> f64 {
    let (z1, z2) = teeth(j);
    let psi = match side(j) {
        Side::Outside => theta + 180.0 + (180.0 + theta * z1) / z2,
        Side::RingIsBase => theta + (180.0 - theta * z1) / z2,
        Side::RingIsIncoming => theta + 180.0 + (180.0 - (theta + 180.0) * z1) / z2,
    };
    let pitch = 360.0 / z2;
    let rest = libm::fmod(psi, pitch);
    if rest < 0.0 { rest + pitch } else { rest }
}

fn relative(j: &Joint<'_>) -> Placement {
    let theta = j.number("angle_deg");
    let (sin, cos) = sin_cos_deg(theta);
    let a = centre_distance(j);
    Placement::translation(a * cos, a * sin, 0.0) * Placement::rotation_z(phase_deg(j, theta))
}

/// The direction of the centre line is free: it turns against the base port as the base gear does. The
/// phase is held against the one that belongs to the actual direction.
fn residual(j: &Joint<'_>, actual: &Placement) -> Residual {
    let (o, [x, _, z]) = (actual.origin(), actual.axes());
    let tilt = between_deg(&z, &nalgebra::Vector3::z());
    let deg = 180.0 / core::f64::consts::PI;
    let theta = libm::atan2(o.y, o.x) * deg;
    let pitch = 360.0 / teeth(j).1;
    let off = (libm::atan2(x.y, x.x) * deg - phase_deg(j, theta)) / pitch;
    let phase = (off - libm::round(off)).abs() * pitch;
    Residual {
        distance_mm: libm::hypot(libm::hypot(o.x, o.y) - centre_distance(j), o.z),
        // Not `max` alone: it would drop what is no number.
        angle_deg: if tilt >= phase { tilt } else { phase },
    }
}

fn conditions(j: &Joint<'_>) -> Vec<Condition> {
    let (b, c) = (j.base, j.incoming);
    let mut out = Vec::new();
    let mut same = |name: &str, found: f64, wanted: f64, tolerance: f64, what: &str| {
        // Written so that an unknown value matches nothing.
        if !at_most((found - wanted).abs(), tolerance) {
            out.push(Condition {
                message: format!("{what} of '{}' and '{}' do not go together", b.name, c.name),
                found,
                expected: format!("{name} = {wanted}"),
            });
        }
    };
    // These tolerances take up decimal fractions only.
    same(
        "module",
        c.value("module"),
        b.value("module"),
        1e-9,
        "the modules",
    );
    let angle = "pressure_angle_deg";
    same(
        angle,
        c.value(angle),
        b.value(angle),
        1e-9,
        "the pressure angles",
    );
    let hand = if side(j) == Side::Outside { -1.0 } else { 1.0 };
    let helix = "helix_angle_deg";
    // Adding 0.0 turns -0.0 into 0.0.
    same(
        helix,
        c.value(helix),
        hand * b.value(helix) + 0.0,
        1e-9,
        "the helix angles",
    );
    // Shifts that do not cancel need a centre distance of their own, which is not computed here.
    let shift = "profile_shift";
    same(
        shift,
        c.value(shift),
        hand * b.value(shift) + 0.0,
        1e-9,
        "the profile shifts",
    );
    let (z1, z2) = teeth(j);
    if b.value("internal") == 1.0 && c.value("internal") == 1.0 {
        out.push(Condition {
            message: "two internal gears do not mesh".to_owned(),
            found: 1.0,
            expected: "at most one gear with internal = 1".to_owned(),
        });
    } else if side(j) != Side::Outside {
        let (ring, pinion) = if side(j) == Side::RingIsBase {
            (z1, z2)
        } else {
            (z2, z1)
        };
        if !over(ring, pinion) {
            out.push(Condition {
                message: format!("a pinion of {pinion} teeth does not go into a ring of {ring}"),
                found: pinion,
                expected: format!("fewer than {ring} teeth"),
            });
        }
    }
    let (m, r) = (j.number("m"), j.number("r"));
    if m != 0.0 && !at_most((m - b.value("module")).abs(), 1e-9) {
        out.push(Condition {
            message: format!(
                "the mate states module {m} mm, the gears have {} mm",
                b.value("module")
            ),
            found: m,
            expected: format!("m = {}", b.value("module")),
        });
    }
    // Half a percent, so that 7/3 may be written 2.33.
    if r != 0.0 && !at_most((r - z2 / z1).abs(), 5e-3 * r) {
        out.push(Condition {
            message: format!(
                "the mate states the ratio {r}, the gears have {z2} / {z1} = {}",
                z2 / z1
            ),
            found: r,
            expected: format!("r = {}", z2 / z1),
        });
    }
    out
}

/// The rotations of the two gears about their own axes, coupled: outside they turn against each other, a
/// ring and its pinion the same way. The twist is what is left between the gears themselves: the base turns
/// by 1 and the incoming by the ratio, seen from the base.
fn freedom(j: &Joint<'_>) -> Freedom {
    let (z1, z2) = teeth(j);
    let ratio = if side(j) == Side::Outside {
        -z1 / z2
    } else {
        z1 / z2
    };
    let (sin, cos) = sin_cos_deg(j.number("angle_deg"));
    let a = centre_distance(j);
    // A turn about an axis along z through c moves the origin by -z x c = (c_y, -c_x).
    let (vx, vy) = (a * sin, -a * cos);
    let incoming = Twist([0.0, 0.0, 1.0, vx, vy, 0.0]);
    Freedom {
        twists: vec![Twist([0.0, 0.0, ratio - 1.0, ratio * vx, ratio * vy, 0.0])],
        coupling: Some(Coupling {
            base: super::SPIN,
            incoming,
            ratio,
        }),
    }
}

/// By how much the incoming gear can be turned either way before flanks must meet, in degrees: half the
/// backlash of the mate and of the thinned teeth, along the pitch circle in the normal section, and the
/// flanks' own tolerance.
fn window_deg(j: &Joint<'_>) -> f64 {
    let thinned = j.base.value("thinning") + j.incoming.value("thinning");
    let arc = (j.number("backlash_mm") + thinned) / 2.0 + FLANK_SHARE * j.base.value("module");
    let cos = sin_cos_deg(j.base.value("helix_angle_deg")).1;
    arc / cos / radius(j.incoming) * 180.0 / core::f64::consts::PI
}

/// Nothing but what approximated flanks may lie in each other: [`FLANK_MM`] over both flanks of two teeth,
/// each 2.25 modules high.
fn overlap(j: &Joint<'_>) -> Overlap {
    let width = j.base.value("width").min(j.incoming.value("width"));
    Overlap {
        least_mm3: 0.0,
        most_mm3: FLANK_MM * 4.0 * 2.25 * j.base.value("module") * width,
        why: "the tolerance of the gears' flanks".to_owned(),
    }
}
