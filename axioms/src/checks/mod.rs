//! The checks: one file each, which reads facts and yields verdicts.
//!
//! A check says nothing of what it does not apply to; where it cannot tell, it says so and why; what it
//! takes for granted stands in the verdict.

use crate::axiom::Axiom;
use crate::facts::Facts;
use crate::indexed::Indexed;
use crate::knowledge::axioms;
use crate::ruling::{About, Ruling, Status};

mod anti_rotation;
mod assembly_order;
mod axial_location;
mod axis_alignment;
mod backlash;
mod base_first;
mod bolt_length;
mod bore_wall;
mod bracket_legs;
mod centre_distance;
mod clamping;
mod clearance_hole;
mod contact_at_seat;
mod contact_ratio;
mod edge_distance;
mod engagement_length;
mod fastener_access;
mod features_named;
mod fixed_and_floating;
mod gear_loop;
mod ground_named;
mod head_seat;
mod helix_hand;
mod hinge_line;
mod hole_pattern;
mod hole_spacing;
mod hub_length;
mod interference;
mod knuckle_play;
mod load_path;
mod mobility_as_intended;
mod no_redundant_constraint;
mod no_unmeant_overlap;
mod part_connected;
mod pin_fit;
mod pin_reach;
mod pin_retention;
mod plane_alignment;
mod planet_spacing;
mod prismatic_freedom;
mod revolute_freedom;
mod ring_fit;
mod ring_seats;
mod screw_freedom;
mod seat_on_face;
mod set_screw_seat;
mod shaft_angle;
mod shaft_support;
mod snap_lock;
mod stable_footing;
mod thread_bottoming;
mod thread_match;
mod tip_clearance;
mod tooth_system;
mod torque_path;
mod undercut;
mod washer_on_slot;

/// A check of one axiom.
pub trait Check: Sync {
    /// The name, as the axiom's data have it.
    fn id(&self) -> &'static str;
    /// The id of the axiom.
    fn axiom(&self) -> &'static str;
    /// The verdicts, one for each subject; none where there is nothing to check.
    fn run(&self, facts: &Indexed) -> Vec<Ruling>;
}

/// Every check that is written, sorted by name.
pub static ALL: [&dyn Check; 57] = [
    &anti_rotation::AntiRotation,
    &assembly_order::AssemblyOrder,
    &axial_location::AxialLocation,
    &axis_alignment::AxisAlignment,
    &backlash::Backlash,
    &base_first::BaseFirst,
    &bolt_length::BoltLength,
    &bore_wall::BoreWall,
    &bracket_legs::BracketLegs,
    &centre_distance::CentreDistance,
    &clamping::Clamping,
    &clearance_hole::ClearanceHole,
    &contact_at_seat::ContactAtSeat,
    &contact_ratio::ContactRatio,
    &edge_distance::EdgeDistance,
    &engagement_length::EngagementLength,
    &fastener_access::FastenerAccess,
    &features_named::FeaturesNamed,
    &fixed_and_floating::FixedAndFloating,
    &gear_loop::GearLoop,
    &ground_named::GroundNamed,
    &head_seat::HeadSeat,
    &helix_hand::HelixHand,
    &hinge_line::HingeLine,
    &hole_pattern::HolePattern,
    &hole_spacing::HoleSpacing,
    &hub_length::HubLength,
    &interference::Interference,
    &knuckle_play::KnucklePlay,
    &load_path::LoadPath,
    &mobility_as_intended::MobilityAsIntended,
    &no_redundant_constraint::NoRedundantConstraint,
    &no_unmeant_overlap::NoUnmeantOverlap,
    &part_connected::PartConnected,
    &pin_fit::PinFit,
    &pin_reach::PinReach,
    &pin_retention::PinRetention,
    &plane_alignment::PlaneAlignment,
    &planet_spacing::PlanetSpacing,
    &prismatic_freedom::PrismaticFreedom,
    &revolute_freedom::RevoluteFreedom,
    &ring_fit::RingFit,
    &ring_seats::RingSeats,
    &screw_freedom::ScrewFreedom,
    &seat_on_face::SeatOnFace,
    &set_screw_seat::SetScrewSeat,
    &shaft_angle::ShaftAngle,
    &shaft_support::ShaftSupport,
    &snap_lock::SnapLock,
    &stable_footing::StableFooting,
    &thread_bottoming::ThreadBottoming,
    &thread_match::ThreadMatch,
    &tip_clearance::TipClearance,
    &tooth_system::ToothSystem,
    &torque_path::TorquePath,
    &undercut::Undercut,
    &washer_on_slot::WasherOnSlot,
];

/// The written check of an axiom.
#[must_use]
pub fn of(axiom: &Axiom) -> Option<&'static dyn Check> {
    let id = axiom.check.id()?;
    ALL.iter().find(|c| c.id() == id).copied()
}

/// The verdicts of all checks, in the order of the axioms' ids. A check that has nothing to check says
/// `not_applicable` once; an axiom whose check is not written says nothing.
#[must_use]
pub fn run_all(facts: &Facts) -> Vec<Ruling> {
    run_all_on(&Indexed::new(facts.clone()))
}

/// As [`run_all`], of facts with their indices.
#[must_use]
pub fn run_all_on(facts: &Indexed) -> Vec<Ruling> {
    let mut out = Vec::new();
    for axiom in axioms() {
        let Some(check) = of(axiom) else { continue };
        let verdicts = check.run(facts);
        if verdicts.is_empty() {
            out.push(Ruling::new(
                &axiom.id,
                Status::NotApplicable,
                About::assembly(),
                "nothing here that it is about",
            ));
        }
        out.extend(verdicts);
    }
    out
}

/// The axioms that could be checked but whose check is not written: a report names them as not checked.
pub fn not_written() -> impl Iterator<Item = &'static Axiom> {
    axioms()
        .iter()
        .filter(|a| a.check.id().is_some() && of(a).is_none())
}
