//! Small geometry on placed ports.

use assemcad_model::angle::between_deg;
use assemcad_model::frame::Placement;

/// Within this distance, in mm, places count as the same: far below any tolerance of manufacture.
pub(crate) const NEAR_MM: f64 = 1e-3;

/// Within this angle, in degrees, directions count as the same.
pub(crate) const NEAR_DEG: f64 = 1e-3;

/// How far the origin of a frame is off the z axis of the frame from which it is seen.
pub(crate) fn off_axis_mm(seen: &Placement) -> f64 {
    let o = seen.origin();
    libm::hypot(o.x, o.y)
}

/// The angle between the z axis and that of the frame from which it is seen, from 0 to 180.
pub(crate) fn z_angle_deg(seen: &Placement) -> f64 {
    let [_, _, z] = seen.axes();
    let [_, _, own] = Placement::IDENTITY.axes();
    between_deg(&z, &own)
}

/// The angle between two axes without a sense, from 0 to 90.
pub(crate) fn askew_deg(seen: &Placement) -> f64 {
    let angle = z_angle_deg(seen);
    angle.min(180.0 - angle)
}

/// Whether two axes lie on one line.
pub(crate) fn collinear(seen: &Placement) -> bool {
    // The cheaper question first: most axes are elsewhere.
    off_axis_mm(seen) <= NEAR_MM && askew_deg(seen) <= NEAR_DEG
}
