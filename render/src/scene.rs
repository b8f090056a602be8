//! What is drawn.

use std::sync::Arc;

use assemcad_model::frame::{Frame, Placement};

use crate::camera::Eye;

/// The surface of a solid in its own frame: triangles, counter-clockwise seen from outside.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Surface {
    /// Nodes in mm.
    pub positions: Vec<[f64; 3]>,
    /// Unit normals out of the material, one for each node.
    pub normals: Vec<[f64; 3]>,
    /// Three nodes each.
    pub triangles: Vec<[u32; 3]>,
    /// Which triangles show cut material; none where it is empty. It is hatched, and where two bodies were
    /// cut in one place it has the colour [`crate::ALARM`].
    pub cut: Vec<bool>,
    /// The edges that are drawn.
    pub edges: Vec<Chain>,
}

/// Points that are joined by straight lines, in mm.
pub type Chain = Vec<[f64; 3]>;

/// How a body is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Look {
    /// Opaque.
    Solid,
    /// Its shape in grey glass, as surroundings.
    Ghost,
    /// In glass of its own colour, so that one sees into it.
    Glass,
}

/// A solid in its place.
#[derive(Debug, Clone)]
pub struct Body {
    /// Its surface.
    pub surface: Arc<Surface>,
    /// Where it is.
    pub placement: Placement,
    /// Red, green, blue from 0 to 1.
    pub color: [f64; 3],
    /// How it is drawn.
    pub look: Look,
    /// Whether the camera makes room for it.
    pub fit: bool,
}

/// A frame that is shown with a name.
#[derive(Debug, Clone, PartialEq)]
pub struct Mark {
    /// Where, in the world.
    pub frame: Frame,
    /// Its name.
    pub label: String,
    /// Whether its axes are drawn long: a part's frame rather than a port's.
    pub large: bool,
}

/// What one camera sees.
#[derive(Debug, Clone)]
pub struct Panel {
    /// What stands above it.
    pub title: String,
    /// From where it is seen.
    pub eye: Eye,
    /// The solids.
    pub bodies: Vec<Body>,
    /// The frames.
    pub marks: Vec<Mark>,
    /// Whether the solids are where they belong: drawn apart, what lies in one place is no overlap.
    pub in_place: bool,
}

/// A line of the legend.
#[derive(Debug, Clone, PartialEq)]
pub struct Entry {
    /// Red, green, blue from 0 to 1.
    pub color: [f64; 3],
    /// What has this colour.
    pub label: String,
}

/// A whole picture.
#[derive(Debug, Clone)]
pub struct Sheet {
    /// Width in pixels.
    pub width: u32,
    /// Height in pixels.
    pub height: u32,
    /// The views, in rows from the top left.
    pub panels: Vec<Panel>,
    /// The legend below them.
    pub legend: Vec<Entry>,
    /// What else must be said, such as what is missing; above the legend.
    pub notes: Vec<String>,
}
