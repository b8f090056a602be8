//! Gears in mesh, proved on placed solids.
//!
//! # The phase
//!
//! Gear 1 stands at the origin, gear 2 at the distance a = r_1 + r_2 in the direction beta, both with z
//! along the same axis; a tooth of gear i is in the direction phi_i from its own axis. The pitch circles
//! touch at the pitch point, and rolling on each other pass equal arcs there: it is enough that, measured
//! along the common tangent, the teeth of one are half a pitch p off those of the other.
//!
//! Let e be the tangent at the pitch point, to the left of the direction beta. Gear 1 sees the pitch point
//! in the direction beta and turns along e: its teeth are at the arcs r_1 (phi_1 - beta) + k p from it.
//! Gear 2 sees it in the direction beta + 180 degrees, where turning left goes along -e: its teeth are at
//! -r_2 (phi_2 - beta - pi) + k p. Half a pitch between them, with r_i = z_i p / 2 pi, is
//!
//! `z_1 (phi_1 - beta) + z_2 (phi_2 - beta - pi) = pi`   modulo 2 pi.
//!
//! With a tooth of gear 1 on the centre line (phi_1 = beta = 0) gear 2 is turned by half a pitch where z_2
//! is even and not at all where it is odd: the parity of z_1 says nothing, nor does that of the sum.
//!
//! # The gap
//!
//! In the middle of its play each flank stands off its partner by half the play along the line of action:
//! of backlash j along the pitch circles that is j cos(alpha) / 2 (ISO 21771), on both sides of a tooth.
//! Exact flanks without backlash would have no gap and no overlap, and flanks inside of the involute by
//! up to the tolerance have a gap of at most twice that.

use core::f64::consts::PI;

use assemcad_kernel::Shape;
use assemcad_kernel::pair::{common, distance};
use assemcad_model::angle::sin_cos_deg;
use assemcad_model::frame::{Frame, Placement};
use assemcad_model::mates::MateType;
use assemcad_model::ports::Port;
use serde_json::json;

use crate::gears::{FLANK, Gear, PLAIN};

/// The smallest distance is found to about this, in mm.
const NUMERIC: f64 = 1e-6;

struct Pair {
    gears: [Gear; 2],
    solids: [Shape; 2],
    ports: [Vec<Port>; 2],
}

/// A direction of the centre line and of a tooth of gear 1, in degrees.
#[derive(Debug, Clone, Copy)]
struct Pose {
    beta: f64,
    phi: f64,
}

impl Pair {
    /// Narrow gears with large bores: what is not near the mesh only costs time.
    fn new(z1: u32, z2: u32, module: f64, thinner: [f64; 2], shift: f64) -> Self {
        let gear = |teeth: u32, thinner: f64, shift: f64| {
            let gear = Gear {
                module,
                teeth,
                width: 4.0,
                thinner,
                shift,
                ..PLAIN
            };
            Gear {
                bore_d: 2.0 * (gear.root_radius() - module),
                ..gear
            }
        };
        let gears = [gear(z1, thinner[0], shift), gear(z2, thinner[1], -shift)];
        let [(s1, p1), (s2, p2)] = gears.map(|g| g.built());
        Self {
            gears,
            solids: [s1, s2],
            ports: [p1, p2],
        }
    }

    fn teeth(&self) -> [f64; 2] {
        self.gears.map(|g| f64::from(g.teeth))
    }

    /// The direction of a tooth of gear 2, in degrees, by the derivation above.
    fn phase(&self, pose: Pose) -> f64 {
        let [z1, z2] = self.teeth();
        pose.beta + 180.0 + (180.0 - z1 * (pose.phi - pose.beta)) / z2
    }

    fn placements(&self, pose: Pose, phi2: f64) -> [Placement; 2] {
        let a = self.gears[0].pitch_radius() + self.gears[1].pitch_radius();
        let (sin, cos) = sin_cos_deg(pose.beta);
        [
            Placement::rotation_z(pose.phi),
            Placement::translation(a * cos, a * sin, 0.0) * Placement::rotation_z(phi2),
        ]
    }

    fn overlap(&self, [a, b]: &[Placement; 2]) -> f64 {
        let found = common(&self.solids[0], a, &self.solids[1], b).unwrap();
        assert!(found.warnings.is_empty(), "{:?}", found.warnings);
        found.volume
    }

    /// The smallest distance of the teeth about the pitch point.
    ///
    /// Only what is in a box about it is measured, to save time: both pieces are parts of their gears, so
    /// that none is nearer than the gears are, and all contact of flanks is within two modules of the
    /// pitch circles and, along the line of action, within the pitch m pi cos(alpha) of the pitch point.
    fn gap(&self, pose: Pose, at: &[Placement; 2]) -> f64 {
        let (m, r) = (self.gears[0].module, self.gears[0].pitch_radius());
        let here = Placement::rotation_z(pose.beta);
        let corner = here * Placement::translation(r - 2.0 * m, -3.5 * m, -1.0);
        let frame = corner.frame(&Frame::WORLD);
        let around = Shape::cuboid(&frame, [4.0 * m, 7.0 * m, 6.0]).unwrap();
        let one = self.solids[0]
            .placed(&at[0])
            .unwrap()
            .shared(&[&around], None);
        let two = self.solids[1]
            .placed(&at[1])
            .unwrap()
            .shared(&[&around], None);
        let here = Placement::IDENTITY;
        distance(&one.unwrap(), &here, &two.unwrap(), &here)
            .unwrap()
            .distance
    }

    /// No overlap, and the gap of the backlash.
    fn meshes(&self, pose: Pose) {
        let at = self.placements(pose, self.phase(pose));
        let told = format!("{:?} {pose:?}", self.gears.map(|g| g.teeth));
        let overlap = self.overlap(&at);
        assert!(overlap < 1e-9, "{told}: {overlap} mm3 in common");
        let gap = self.gap(pose, &at);
        let backlash = self.gears[0].thinner + self.gears[1].thinner;
        let wanted = backlash / 2.0 * libm::cos(self.gears[0].alpha_deg * PI / 180.0);
        assert!(
            gap >= wanted - NUMERIC && gap <= wanted + 2.0 * FLANK + NUMERIC,
            "{told}: a gap of {gap} mm for {wanted}"
        );
    }

    /// The published rule turns gear 2 by half a pitch where z_1 + z_2 is odd. With a tooth of gear 1 on
    /// the centre line that is right for odd z_1 only; elsewhere a tooth stands upon a tooth.
    fn published(&self, z1: u32, z2: u32) {
        let turn = if (z1 + z2) % 2 == 1 {
            180.0 / f64::from(z2)
        } else {
            0.0
        };
        let pose = Pose {
            beta: 0.0,
            phi: 0.0,
        };
        let overlap = self.overlap(&self.placements(pose, turn));
        if z1 % 2 == 1 {
            assert!(overlap < 1e-9, "{z1} {z2}: {overlap}");
        } else {
            // 2 m deep, and at the pitch circles half a pitch wide.
            assert!(overlap > 10.0, "{z1} {z2}: {overlap}");
        }
    }

    /// The mate against the derivation, and its wider centre distance against the gap.
    fn mated(&self) {
        let [_, z2] = self.teeth();
        let kind = MateType::GearMesh.kind();
        let port = |ports: &'_ [Port]| {
            let found = ports.iter().find(|p| p.name == "mesh_point");
            found.unwrap().clone()
        };
        let [base, incoming] = [port(&self.ports[0]), port(&self.ports[1])];
        for (beta, backlash) in [(0.0, 0.0), (90.0, 0.2), (-110.0, 0.0), (37.0, 0.2)] {
            let given = json!({"angle_deg": beta, "backlash_mm": backlash});
            let options = kind.check_options(given.as_object().unwrap(), "options");
            let placed = kind
                .place_incoming(&Placement::IDENTITY, &base, &incoming, &options.unwrap())
                .unwrap();
            let pose = Pose { beta, phi: 0.0 };
            let [one, two] = self.placements(pose, self.phase(pose));
            // Moving the axes apart by da frees da tan(alpha) on each flank.
            let a = two.origin().norm();
            let wider = a + backlash / (2.0 * libm::tan(PI / 9.0));
            assert!((placed.origin() - two.origin() * (wider / a)).norm() < 1e-9);
            // The same up to whole teeth.
            let turn = |p: &Placement| {
                let [x, y, _] = p.direction([1.0, 0.0, 0.0]);
                libm::atan2(y, x) * z2 / (2.0 * PI)
            };
            let off = turn(&placed) - turn(&two);
            assert!((off - off.round()).abs() < 1e-9, "{beta}: {off}");
            if beta == 37.0 {
                // In the middle of its play the gear has half of it on either side; to the first order
                // of the widening, the next is smaller by its ratio to the centre distance.
                let gap = self.gap(pose, &[one, placed]);
                let half = backlash * libm::cos(PI / 9.0) / 2.0;
                assert!(
                    (gap - half).abs() < 2.0 * FLANK + half * (wider - a) / a * 4.0,
                    "{gap} for {half}"
                );
            }
        }
    }
}

/// Poses while gear 1 turns by its pitch, for a direction of the centre line.
fn rolling(teeth: u32, beta: f64, steps: u32) -> impl Iterator<Item = Pose> {
    let pitch = 360.0 / f64::from(teeth);
    (0..steps).map(move |n| Pose {
        beta,
        phi: pitch * f64::from(n) / f64::from(steps),
    })
}

/// In mesh for several directions, by the derivation and by the mate; and by the published rule only
/// where z_1 is odd.
fn proved(z1: u32, z2: u32) {
    let pair = Pair::new(z1, z2, 2.0, [0.0; 2], 0.0);
    for (beta, phi) in [(0.0, 0.0), (37.0, 5.0)] {
        pair.meshes(Pose { beta, phi });
    }
    pair.published(z1, z2);
    pair.mated();
}

#[test]
fn an_even_gear_with_even_and_odd_ones() {
    proved(20, 30);
    proved(20, 31);
}

#[test]
fn an_odd_gear_with_even_and_odd_ones() {
    proved(21, 30);
    proved(21, 31);
    proved(17, 23);
}

#[test]
fn rolling_through_a_pitch_keeps_contact_and_never_overlaps() {
    let pair = Pair::new(20, 41, 2.0, [0.0; 2], 0.0);
    for pose in rolling(20, 25.0, 5) {
        pair.meshes(pose);
    }
}

#[test]
fn the_backlash_is_the_gap() {
    let pair = Pair::new(18, 25, 2.0, [0.1, 0.06], 0.0);
    for pose in rolling(18, 0.0, 3) {
        pair.meshes(pose);
    }
}

#[test]
fn shifted_profiles_that_make_up_for_each_other() {
    let pair = Pair::new(14, 30, 1.5, [0.0; 2], 0.3);
    for pose in rolling(14, 200.0, 2) {
        pair.meshes(pose);
    }
}
