//! Pictures of assemblies: what text does not tell.
//!
//! An assembly whose parts cannot all be made or placed is drawn as far as it can be, and the picture
//! says what is missing.

mod bodies;
mod explode;
mod meshes;
mod scene;
mod wanted;
mod words;

use assemcad_geometry::Asker;
use assemcad_model::diagnostic::{Code, Diagnostic, Faults};
use assemcad_placing::Partial;
use assemcad_render::{RenderError, Shown};

pub use wanted::{Camera, Section, Wanted};

/// A picture of an assembly.
#[derive(Debug, Clone, PartialEq)]
pub struct Drawn {
    /// The PNG file.
    pub png: Vec<u8>,
    /// Its pixels, row by row from the top: red, green, blue.
    pub pixels: Vec<[u8; 3]>,
    /// The views' cameras, in their order.
    pub shown: Vec<Shown>,
    /// What the picture shows, in words: scale and directions of each view, what is missing.
    pub caption: String,
}

/// Draws an assembly, as far as it can be made and placed.
///
/// # Errors
/// When there is nothing to draw, or what is asked for has no meaning.
pub async fn draw(
    door: Asker<'_>,
    id: &str,
    part: &Partial,
    wanted: &Wanted,
) -> Result<Drawn, Faults> {
    wanted.check()?;
    let scene = scene::scene(door, id, part, wanted).await?;
    let sheet = scene.sheet;
    let drawing = sheet.clone();
    // Seconds of computing, off the threads that answer other calls.
    let picture = tokio::task::spawn_blocking(move || assemcad_render::draw(&drawing))
        .await
        .map_err(|e| vec![Diagnostic::error(Code::Internal, "render", e.to_string())])?
        .map_err(|e| vec![not_drawn(&e)])?;
    let caption = words::caption(id, wanted, &sheet, &picture, &scene.missing);
    Ok(Drawn {
        png: picture.png,
        pixels: picture.pixels,
        shown: picture.shown,
        caption,
    })
}

fn not_drawn(e: &RenderError) -> Diagnostic {
    match e {
        RenderError::Camera => Diagnostic::error(
            Code::ArgumentInvalid,
            "camera_direction",
            "the camera looks along its up direction, or along none",
        )
        .hint("state a camera_up that is not parallel to the camera's direction"),
        other => Diagnostic::error(Code::Internal, "render", other.to_string()),
    }
}
