//! Recipes: what a factory yields, and all that the kernel needs to make a solid.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::canonical;
use crate::frame::{Frame, Rows};
use crate::ports::Port;

/// The version of the recipe format. Part of every hash: a changed meaning is a changed recipe.
pub const FORMAT: u32 = 1;

/// A list of typed operations and the ports of the solid that the last one makes.
///
/// Operations refer to earlier ones by index, so that a recipe cannot be circular.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Recipe {
    /// [`FORMAT`].
    pub format: u32,
    /// The operations; the last one makes the part's solid.
    pub ops: Vec<Op>,
    /// The ports of the part, in the part's frame.
    pub ports: Vec<Port>,
}

impl Recipe {
    /// The SHA-256 of the canonical JSON: the name of the solid in every cache.
    ///
    /// # Errors
    /// When a number is not finite, which a checked recipe never holds.
    pub fn hash(&self) -> Result<String, serde_json::Error> {
        canonical::hash(self)
    }
}

/// The index of an earlier operation in [`Recipe::ops`].
pub type Ref = u32;

/// One operation. Lengths in mm, angles in degrees.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Op {
    /// A box from the origin of `at` to `size` along its axes.
    Box {
        /// Where.
        at: Frame,
        /// Extent along x, y, z.
        size: [f64; 3],
    },
    /// A cylinder along z of `at`, its base centred on the origin.
    Cylinder {
        /// Where.
        at: Frame,
        /// Radius.
        radius: f64,
        /// Height.
        height: f64,
    },
    /// A cone or its frustum along z of `at`.
    Cone {
        /// Where.
        at: Frame,
        /// Radius at the origin; may be 0.
        radius_base: f64,
        /// Radius at `height`; may be 0, and differs from `radius_base`.
        radius_top: f64,
        /// Height.
        height: f64,
    },
    /// A sphere about the origin of `at`.
    Sphere {
        /// Where.
        at: Frame,
        /// Radius.
        radius: f64,
    },
    /// A closed profile moved along z of its frame.
    Prism {
        /// The profile.
        profile: Profile,
        /// Length of the way; negative goes against z.
        length: f64,
    },
    /// A closed profile turned about an axis in its plane.
    Revolve {
        /// The profile.
        profile: Profile,
        /// A point of the axis, in the profile's plane.
        axis_point: [f64; 2],
        /// The direction of the axis, in the profile's plane.
        axis_direction: [f64; 2],
        /// Angle, right-handed about the axis, over 0 up to 360.
        angle_deg: f64,
    },
    /// The union of two solids; exactly one solid must come out.
    Fuse {
        /// First solid.
        a: Ref,
        /// Second solid.
        b: Ref,
    },
    /// `a` without `b`.
    Cut {
        /// The solid that is cut.
        a: Ref,
        /// The tool.
        b: Ref,
    },
    /// What `a` and `b` have in common.
    Common {
        /// First solid.
        a: Ref,
        /// Second solid.
        b: Ref,
    },
    /// Rounded edges.
    Fillet {
        /// The solid.
        of: Ref,
        /// Which edges.
        edges: EdgeSelector,
        /// Radius.
        radius: f64,
    },
    /// Bevelled edges, at equal distances from the edge on both faces.
    Chamfer {
        /// The solid.
        of: Ref,
        /// Which edges.
        edges: EdgeSelector,
        /// Distance from the edge.
        distance: f64,
    },
    /// A rigid motion.
    Place {
        /// The solid.
        of: Ref,
        /// Where to.
        placement: Rows,
    },
}

impl Op {
    /// The operation's name as it is written in recipes and diagnostics.
    #[must_use]
    pub fn name(&self) -> &'static str {
        match self {
            Self::Box { .. } => "box",
            Self::Cylinder { .. } => "cylinder",
            Self::Cone { .. } => "cone",
            Self::Sphere { .. } => "sphere",
            Self::Prism { .. } => "prism",
            Self::Revolve { .. } => "revolve",
            Self::Fuse { .. } => "fuse",
            Self::Cut { .. } => "cut",
            Self::Common { .. } => "common",
            Self::Fillet { .. } => "fillet",
            Self::Chamfer { .. } => "chamfer",
            Self::Place { .. } => "place",
        }
    }

    /// The operations that this one uses.
    #[must_use]
    pub fn inputs(&self) -> Vec<Ref> {
        match self {
            Self::Fuse { a, b } | Self::Cut { a, b } | Self::Common { a, b } => vec![*a, *b],
            Self::Fillet { of, .. } | Self::Chamfer { of, .. } | Self::Place { of, .. } => {
                vec![*of]
            }
            _ => Vec::new(),
        }
    }

    /// The same operation with its references renamed.
    #[must_use]
    pub fn with_inputs(mut self, rename: impl Fn(Ref) -> Ref) -> Self {
        match &mut self {
            Self::Fuse { a, b } | Self::Cut { a, b } | Self::Common { a, b } => {
                *a = rename(*a);
                *b = rename(*b);
            }
            Self::Fillet { of, .. } | Self::Chamfer { of, .. } | Self::Place { of, .. } => {
                *of = rename(*of);
            }
            _ => {}
        }
        self
    }
}

/// A plane region: an outer outline and the holes in it, in the x-y plane of a frame.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Profile {
    /// The frame whose x-y plane holds the profile.
    pub at: Frame,
    /// The outer outline.
    pub outer: Outline,
    /// Holes, inside the outer outline and apart from each other.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub holes: Vec<Outline>,
}

/// A closed outline in the plane of a profile.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Outline {
    /// A full circle.
    Circle {
        /// Centre.
        center: [f64; 2],
        /// Radius.
        radius: f64,
    },
    /// Segments from a start point; the end is joined to the start by a line where they differ.
    Path {
        /// First point.
        start: [f64; 2],
        /// The segments in order.
        segments: Vec<Segment>,
    },
}

/// One piece of an outline, from where the last one ended.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Segment {
    /// A straight line.
    Line {
        /// End point.
        to: [f64; 2],
    },
    /// A circular arc through a point.
    Arc {
        /// A point between start and end.
        via: [f64; 2],
        /// End point.
        to: [f64; 2],
    },
}

/// Which edges of a solid an operation means.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum EdgeSelector {
    /// Every edge.
    All,
    /// Straight edges along a direction, either way.
    Parallel {
        /// The direction, of any length.
        direction: [f64; 3],
    },
    /// Edges that lie wholly in a plane.
    InPlane {
        /// A point of the plane.
        point: [f64; 3],
        /// The plane's normal, of any length.
        normal: [f64; 3],
    },
}
