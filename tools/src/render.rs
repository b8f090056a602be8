//! `render`.

use assemcad_assembly::{Faults, Workshop};
use assemcad_model::diagnostic::{Code, Diagnostic};
use assemcad_render::{Eye, View};
use assemcad_views::picture::{Camera, Section, Wanted};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::json;

use crate::answer::Picture;
use crate::{Effect, Tool};

pub(crate) struct Render;

#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct Arguments {
    /// Name of the assembly.
    assembly: String,
    /// The views, together on one sheet; isometric where nothing is said.
    #[serde(default)]
    #[schemars(length(max = 7))]
    views: Vec<Name>,
    /// A view of your own instead: the direction in which the camera looks, as [x, y, z].
    #[serde(default)]
    camera_direction: Option<[f64; 3]>,
    /// What is up in that view; [0, 0, 1] where nothing is said.
    #[serde(default)]
    camera_up: Option<[f64; 3]>,
    /// A close view instead: where the camera stands, in mm.
    #[serde(default)]
    eye_mm: Option<[f64; 3]>,
    /// What it looks at, in mm: the picture's middle. As much is seen as through a lens of 40 degrees.
    #[serde(default)]
    target_mm: Option<[f64; 3]>,
    /// Width of the picture in pixels.
    #[serde(default = "width")]
    #[schemars(range(min = 128, max = 2000))]
    width_px: u32,
    /// Height of the picture in pixels.
    #[serde(default = "height")]
    #[schemars(range(min = 128, max = 2000))]
    height_px: u32,
    /// Show every port with its name (x red, y green, z blue).
    #[serde(default)]
    ports: bool,
    /// Show every part's own frame with the part's name.
    #[serde(default)]
    frames: bool,
    /// Draw the parts apart along the axes of their mates: 0 not at all, 1 just clear of each other.
    #[serde(default)]
    #[schemars(range(min = 0.0, max = 10.0))]
    explode: f64,
    /// Cut the assembly across this axis; the viewer's side is taken away, cut material is hatched.
    #[serde(default)]
    section_axis: Option<Axis>,
    /// Where on that axis the cut is, in mm.
    #[serde(default)]
    #[schemars(range(min = -1e6, max = 1e6))]
    section_offset_mm: f64,
    /// Two parts that stand out, [part, part]: all others are grey glass, and what the two have in
    /// common is red.
    #[serde(default)]
    highlight: Option<[String; 2]>,
    /// Also leave the picture as a file beside the assembly's specification.
    #[serde(default)]
    file: bool,
}

fn width() -> u32 {
    1024
}

fn height() -> u32 {
    768
}

/// The named views: front looks along +y, top along -z.
#[derive(Debug, Clone, Copy, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
enum Name {
    Isometric,
    Front,
    Back,
    Left,
    Right,
    Top,
    Bottom,
}

/// An axis of the assembly.
#[derive(Debug, Clone, Copy, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
enum Axis {
    X,
    Y,
    Z,
}

impl Tool for Render {
    type Arguments = Arguments;
    type Answer = Picture;
    const NAME: &'static str = "render";
    const TITLE: &'static str = "Draw an assembly";
    const DESCRIPTION: &'static str = "Draws an assembly as a PNG picture to look at: shaded, edges dark, \
        a colour per part with a legend, axes, a scale; on request ports, exploded, cut open, or a pair of \
        parts with their clash in red. It shows what numbers hide: a part on the wrong side, upside \
        down or floating. A picture proves nothing: verify checks, measure gives numbers. Parts that \
        cannot be made or have no place are named in the picture. A picture costs about 1000 tokens; \
        several views on one sheet cost no more than one.";
    const EFFECT: Effect = Effect::Adds;

    async fn run(workshop: &Workshop, a: Arguments) -> Result<Picture, Faults> {
        let wanted = a.wanted()?;
        let drawn = workshop.draw(&a.assembly, &wanted).await?;
        let mut caption = drawn.caption;
        if a.file {
            let kept = match workshop.keep_picture(&a.assembly, &wanted, &drawn.png) {
                Ok(file) => format!("\nFile: {file} ({} bytes).", drawn.png.len()),
                // The picture is there to be looked at all the same.
                Err(d) => format!("\nNo file was kept: {d}."),
            };
            caption.push_str(&kept);
        }
        Ok(Picture {
            caption,
            png: drawn.png,
        })
    }
}

impl Arguments {
    fn wanted(&self) -> Result<Wanted, Faults> {
        let camera = self.camera().map_err(|d| vec![d])?;
        let views = match camera {
            Some(eye) => vec![Camera::Free(eye)],
            None if self.views.is_empty() => vec![Camera::View(View::Isometric)],
            None => self.views.iter().map(|v| Camera::View(v.view())).collect(),
        };
        if self.section_axis.is_none() && self.section_offset_mm != 0.0 {
            return Err(vec![
                Diagnostic::error(
                    Code::ArgumentInvalid,
                    "section_axis",
                    "'section_offset_mm' says where, but not across which axis",
                )
                .expected(json!(["x", "y", "z"])),
            ]);
        }
        let section = self.section_axis.map(|axis| Section {
            axis: match axis {
                Axis::X => 0,
                Axis::Y => 1,
                Axis::Z => 2,
            },
            offset_mm: self.section_offset_mm,
        });
        Ok(Wanted {
            views,
            width: self.width_px,
            height: self.height_px,
            ports: self.ports,
            frames: self.frames,
            explode: self.explode,
            section,
            highlight: self.highlight.clone(),
        })
    }

    /// The chosen camera, where one is chosen.
    fn camera(&self) -> Result<Option<Eye>, Diagnostic> {
        let wrong = |place: &str, message: &str| {
            Err(Diagnostic::error(Code::ArgumentInvalid, place, message)
                .hint("state views, or camera_direction, or eye_mm and target_mm"))
        };
        let up = self.camera_up.unwrap_or([0.0, 0.0, 1.0]);
        let eye = match (self.camera_direction, self.eye_mm, self.target_mm) {
            (None, None, None) if self.camera_up.is_some() => {
                return wrong("camera_up", "it belongs to a camera, and none is stated");
            }
            (None, None, None) => return Ok(None),
            (Some([x, y, z]), None, None) => Eye {
                toward: [0.0 - x, 0.0 - y, 0.0 - z],
                up,
                aim: None,
            },
            (None, Some([a, b, c]), Some(target)) => {
                let [x, y, z] = target;
                let toward = [a - x, b - y, c - z];
                let away = toward.iter().map(|d| d * d).sum::<f64>().sqrt();
                if !(1e-3..1e7).contains(&away) {
                    return wrong("eye_mm", "the eye is in its target, or too far from it");
                }
                Eye {
                    toward,
                    up,
                    aim: Some((target, LENS * away)),
                }
            }
            (Some(_), ..) => {
                return wrong(
                    "camera_direction",
                    "a camera has either a direction or an eye and a target",
                );
            }
            (None, None, Some(_)) => return wrong("eye_mm", "'eye_mm' is missing"),
            (None, Some(_), None) => return wrong("target_mm", "'target_mm' is missing"),
        };
        if !self.views.is_empty() {
            return wrong(
                "views",
                "a chosen camera takes the place of the named views",
            );
        }
        Ok(Some(eye))
    }
}

/// What a lens of 40 degrees sees of the height at a distance of 1: 2 tan 20 degrees.
const LENS: f64 = 0.727_940_468_532_405;

impl Name {
    fn view(self) -> View {
        match self {
            Self::Isometric => View::Isometric,
            Self::Front => View::Front,
            Self::Back => View::Back,
            Self::Left => View::Left,
            Self::Right => View::Right,
            Self::Top => View::Top,
            Self::Bottom => View::Bottom,
        }
    }
}
