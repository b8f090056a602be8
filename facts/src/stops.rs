//! Which gaps still stop a part soon enough to hold it within a play, and which are too wide to hold anything.

use assemcad_geometry::narrow::meet::{Kind, Meeting, REACH_MM};

/// The largest play of the loosest running fit of ISO 286-1, H11/a11, in mm on the diameter: up to and including
/// a diameter, the fundamental deviation of a and twice the tolerance IT11.
const LOOSEST: [(f64, f64); 13] = [
    (3.0, 0.270 + 2.0 * 0.060),
    (6.0, 0.270 + 2.0 * 0.075),
    (10.0, 0.280 + 2.0 * 0.090),
    (18.0, 0.290 + 2.0 * 0.110),
    (30.0, 0.300 + 2.0 * 0.130),
    (40.0, 0.310 + 2.0 * 0.160),
    (50.0, 0.320 + 2.0 * 0.160),
    (65.0, 0.340 + 2.0 * 0.190),
    (80.0, 0.360 + 2.0 * 0.190),
    (100.0, 0.380 + 2.0 * 0.220),
    (120.0, 0.410 + 2.0 * 0.220),
    (140.0, 0.460 + 2.0 * 0.250),
    (160.0, 0.520 + 2.0 * 0.250),
];

/// The widest play on the diameter that still guides, in mm; beyond the table in proportion.
#[must_use]
pub(crate) fn loosest_mm(diameter: f64) -> f64 {
    let row = LOOSEST.iter().find(|(most, _)| diameter <= *most);
    row.map_or(diameter * (1.02 / 160.0), |(_, play)| *play)
}

/// Whether a contact, or a gap, holds a part within a play.
#[must_use]
pub fn stops(meeting: &Meeting) -> bool {
    match (meeting.kind, &meeting.about) {
        (Kind::Cylinder | Kind::Cone, Some(about)) => {
            2.0 * meeting.gap_mm <= loosest_mm(2.0 * about.hole_mm.abs()) + 1e-6
        }
        _ => meeting.gap_mm <= REACH_MM,
    }
}
