//! What moves: placed parts and the motion that drives them.

use assemcad_geometry::Asker;
use assemcad_model::frame::Placement;
use assemcad_model::freedom::{Drive, Pose};
use assemcad_placing::Assembled;

/// Everything that a sweep looks at.
pub(crate) struct Mechanism<'a> {
    pub(crate) door: Asker<'a>,
    pub(crate) assembled: Assembled<'a>,
    pub(crate) drive: &'a Drive,
}

impl Mechanism<'_> {
    /// Where a part is in a pose.
    pub(crate) fn place(&self, pose: &Pose, part: usize) -> Option<Placement> {
        Some(self.drive.moved(pose, part) * self.assembled.placements.of(part)?)
    }
}
