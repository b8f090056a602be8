//! Pictures of placed solids: triangles and edges in, PNG out.
//!
//! In software, in one thread, with IEEE arithmetic alone: the same scene gives the same bytes in
//! every process. Nothing here knows of kernels or assemblies.
//!
//! A picture is a [`Sheet`] of panels. A panel is seen by one camera in parallel projection; its solids
//! are drawn into depth buffers at twice the resolution (`raster`), these are laid over each other and
//! get their outlines (`paint`), and scale, axes and labels come on top (`overlay`).

mod camera;
mod canvas;
mod encode;
mod legend;
mod overlay;
mod paint;
mod raster;
mod scene;
mod sheet;
mod text;

pub use camera::{Camera, Eye, View};
pub use paint::ALARM;
pub use scene::{Body, Chain, Entry, Look, Mark, Panel, Sheet, Surface};
pub use sheet::{Picture, Shown, draw};

/// Why there is no picture.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum RenderError {
    /// The picture has no pixels or too many.
    #[error("a picture has {LEAST_PX} to {MOST_PX} pixels a side")]
    Size,
    /// Looking along `up`, or along no direction.
    #[error("the camera's direction and its up direction must have a length and not be parallel")]
    Camera,
    /// There is no panel to draw.
    #[error("a picture has at least one view and at most {MOST_PANELS}")]
    Panels,
    /// The picture could not be encoded.
    #[error("the picture could not be encoded: {0}")]
    Encoding(String),
}

/// The smallest side of a picture in pixels.
pub const LEAST_PX: u32 = 128;

/// The largest side of a picture in pixels: what clients of a language model take.
pub const MOST_PX: u32 = 2000;

/// How many views a sheet has at most.
pub const MOST_PANELS: usize = 9;
