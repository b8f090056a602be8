//! The decisions that axioms govern, one each: that is what makes their scopes disjoint.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The single engineering decision that an axiom governs.
#[derive(
    Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize, JsonSchema,
)]
#[serde(rename_all = "snake_case")]
pub enum Decision {
    /// What keeps a joint from turning about its fastener.
    AntiRotation,
    /// From how many directions parts come in.
    AssemblyDirection,
    /// In which order parts are brought in.
    AssemblyOrder,
    /// What holds a shaft along its axis.
    AxialLocation,
    /// Which axes coincide.
    AxisAlignment,
    /// How much play the flanks of a gear pair have.
    Backlash,
    /// Which part the assembly begins with.
    BaseFirst,
    /// How long a bolt with a nut is.
    BoltLength,
    /// How much wall stays around a bore.
    BoreWall,
    /// Which walls of a bracket or channel are joined.
    BracketLegs,
    /// How far the axes of a gear pair are apart.
    CentreDistance,
    /// What a threaded fastener clamps, and between what.
    Clamping,
    /// How wide a hole for a bolt is.
    ClearanceHole,
    /// Where parts touch.
    ContactAtSeat,
    /// How many tooth pairs are in contact.
    ContactRatio,
    /// How far a hole stays from an edge.
    EdgeDistance,
    /// How much thread is engaged.
    EngagementLength,
    /// How a tool reaches a fastener.
    FastenerAccess,
    /// Which bearing of a shaft locates it.
    FixedAndFloating,
    /// Whether a closed ring of gears can turn.
    GearLoop,
    /// Which part stands still.
    GroundChoice,
    /// On what a head or nut sits.
    HeadSeat,
    /// Angle and hand of the helices of a gear pair.
    HelixHand,
    /// Where the places of a hinge lie.
    HingeLine,
    /// How the hole patterns of joined parts lie to each other.
    HolePattern,
    /// How far holes stand apart.
    HoleSpacing,
    /// How long a hub is.
    HubLength,
    /// How much thicker than its hole a pressed part is.
    Interference,
    /// How the knuckles of a hinge follow each other.
    KnucklePlay,
    /// How a load reaches the ground.
    LoadPath,
    /// Whether locating or fastening comes first.
    LocateThenFasten,
    /// What secures a fastener against loosening.
    Loosening,
    /// How many motions the assembly has.
    Mobility,
    /// By which features a connection is stated.
    NamedFeatures,
    /// What joins a part to the others.
    PartConnected,
    /// In which leaf the pin of a hinge turns.
    PinFit,
    /// How far the pin of a hinge reaches.
    PinReach,
    /// What retains the pin of a hinge.
    PinRetention,
    /// How plane faces lie on each other.
    PlaneAlignment,
    /// Teeth and places of planets.
    PlanetSpacing,
    /// What a sliding joint is left.
    PrismaticFreedom,
    /// Which freedom is taken how often.
    RedundantConstraint,
    /// When a retaining part is brought in.
    RetainerAfter,
    /// What a turning joint is left.
    RevoluteFreedom,
    /// Which ring of a bearing is tight.
    RingFit,
    /// Where the rings of a bearing sit.
    RingSeats,
    /// What a drive screw is left.
    ScrewFreedom,
    /// Where on a face a part is set.
    SeatOnFace,
    /// On what a set screw presses.
    SetScrewSeat,
    /// Which kind of gears suits the angle of their axes.
    ShaftAngle,
    /// Where a rotating part is carried.
    ShaftSupport,
    /// Which space two parts may share.
    SharedSpace,
    /// How a snap hook and its catch overlap.
    SnapLock,
    /// On what the assembly stands.
    StableFooting,
    /// How far a leaf swings.
    SwingRange,
    /// How deep a screw may go.
    ThreadBottoming,
    /// Which threads go together.
    ThreadMatch,
    /// How far tips stay from roots.
    TipClearance,
    /// Module, pressure angle and kind of teeth of a gear pair.
    ToothSystem,
    /// How torque passes from shaft to hub.
    TorquePath,
    /// How few teeth a gear may have.
    Undercut,
    /// What lies between a head and a wide hole.
    WasherOnSlot,
}
