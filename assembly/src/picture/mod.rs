//! Pictures of assemblies: what text does not tell.
//!
//! An assembly whose parts cannot all be made or placed is drawn as far as it can be, and the picture
//! says what is missing.

mod bodies;
mod explode;
mod meshes;
mod scene;
mod words;

use assemcad_model::diagnostic::{Code, Diagnostic};
use assemcad_render::{Eye, LEAST_PX, MOST_PANELS, MOST_PX, RenderError, Shown, View, draw};
use serde_json::json;

use crate::store::file_of;
use crate::{Faults, Workshop, partial};

/// From where an assembly is seen.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Camera {
    /// One of the named views.
    View(View),
    /// A chosen one.
    Free(Eye),
}

impl Camera {
    fn eye(&self) -> Eye {
        match self {
            Self::View(view) => view.eye(),
            Self::Free(eye) => *eye,
        }
    }

    /// The view's name.
    #[must_use]
    pub fn name(&self) -> &'static str {
        match self {
            Self::View(view) => view.name(),
            Self::Free(_) => "camera",
        }
    }
}

/// A plane across one of the assembly's axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Section {
    /// 0, 1, 2 for x, y, z.
    pub axis: usize,
    /// Where it is along this axis, in mm.
    pub offset_mm: f64,
}

/// What is to be drawn, and how.
#[derive(Debug, Clone, PartialEq)]
pub struct Wanted {
    /// The views, together on one sheet.
    pub views: Vec<Camera>,
    /// Width of the picture in pixels.
    pub width: u32,
    /// Height of the picture in pixels.
    pub height: u32,
    /// Whether ports are shown with their names.
    pub ports: bool,
    /// Whether the parts' own frames are shown with their names.
    pub frames: bool,
    /// How far the parts are drawn apart: 0 not at all, 1 just clear of each other.
    pub explode: f64,
    /// The plane that takes away what lies before it.
    pub section: Option<Section>,
    /// Two parts that stand out.
    pub highlight: Option<[String; 2]>,
}

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

impl Workshop {
    /// Draws an assembly.
    ///
    /// # Errors
    /// When there is nothing to draw, or what is asked for has no meaning.
    pub async fn draw(&self, id: &str, wanted: &Wanted) -> Result<Drawn, Faults> {
        check(wanted)?;
        let spec = self.store.load(id).map_err(|d| vec![d])?;
        let part = partial::of(self, &spec).await?;
        let scene = self.scene(&spec, &part, wanted).await?;
        let sheet = scene.sheet;
        let drawing = sheet.clone();
        // Seconds of computing, off the threads that answer other calls.
        let picture = tokio::task::spawn_blocking(move || draw(&drawing))
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

    /// Writes a picture beside the assembly's other files and gives its path below the root.
    ///
    /// # Errors
    /// When the file cannot be written.
    pub fn keep_picture(&self, id: &str, wanted: &Wanted, png: &[u8]) -> Result<String, Faults> {
        let name = match wanted.views.as_slice() {
            [one] => one.name(),
            _ => "views",
        };
        let file = file_of(id, &format!("{id}-{name}.png"));
        self.store.write(&file, png).map_err(|d| vec![d])?;
        Ok(file)
    }
}

/// What can be told of a request before anything is made.
fn check(wanted: &Wanted) -> Result<(), Faults> {
    let mut faults = Vec::new();
    let wrong =
        |place: &str, message: &str| Diagnostic::error(Code::ArgumentInvalid, place, message);
    for (place, side) in [("width_px", wanted.width), ("height_px", wanted.height)] {
        if !(LEAST_PX..=MOST_PX).contains(&side) {
            faults.push(
                wrong(place, "a picture has 128 to 2000 pixels a side")
                    .found(side)
                    .expected(json!({"minimum": LEAST_PX, "maximum": MOST_PX})),
            );
        }
    }
    if wanted.views.is_empty() || wanted.views.len() > MOST_PANELS {
        faults.push(
            wrong("views", "a sheet has one to nine views")
                .found(wanted.views.len())
                .expected(json!({"minimum": 1, "maximum": MOST_PANELS})),
        );
    }
    if let Some([a, b]) = &wanted.highlight {
        if a == b {
            faults.push(
                wrong("highlight", "a pair is two different parts")
                    .found(json!([a, b]))
                    .hint("to look at one part, aim the camera at it"),
            );
        }
        if wanted.explode > 0.0 {
            faults.push(
                wrong("explode", "a highlighted pair is shown where it is")
                    .found(wanted.explode)
                    .hint("leave out explode or highlight"),
            );
        }
    }
    if faults.is_empty() {
        Ok(())
    } else {
        Err(faults)
    }
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
