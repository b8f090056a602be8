//! What is to be drawn, and how.

use assemcad_model::diagnostic::{Code, Diagnostic, Faults};
use assemcad_render::{Eye, LEAST_PX, MOST_PANELS, MOST_PX, View};
use serde_json::json;

/// From where an assembly is seen.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Camera {
    /// One of the named views.
    View(View),
    /// A chosen one.
    Free(Eye),
}

impl Camera {
    pub(super) fn eye(&self) -> Eye {
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

impl Wanted {
    /// What can be told of a request before anything is made.
    ///
    /// # Errors
    /// Everything that has no meaning.
    pub fn check(&self) -> Result<(), Faults> {
        let wanted = self;
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
}
