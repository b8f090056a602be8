//! What pictures and measurements ask of the kernel, and its answers.

use assemcad_model::selector::Selector;
use serde::{Deserialize, Serialize};

use crate::named::Named;
use crate::protocol::Placed;

/// A body that is drawn.
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Body {
    /// A part, in its own frame.
    Whole {
        /// How to make it.
        recipe: Named,
    },
    /// What a plane leaves of a part, in the part's frame: the side into which the normal points is
    /// taken away.
    Behind {
        /// How to make the part.
        recipe: Named,
        /// A point of the plane, in the part's frame, in mm.
        point: [f64; 3],
        /// Its normal there.
        normal: [f64; 3],
    },
    /// What two placed parts have in common, in the world.
    Shared {
        /// The first part.
        a: Box<Placed>,
        /// The second part.
        b: Box<Placed>,
    },
}

/// A placed part, or those of its faces that a selector means.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Chosen {
    /// The part.
    pub part: Placed,
    /// Which faces; none for the whole part. The selector speaks of the part's own frame.
    pub faces: Option<Selector>,
}

/// What was measured of a placed part or of faces of it, in the world.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Measured {
    /// Volume in mm3; none for faces.
    pub volume: Option<f64>,
    /// Surface of the part or area of the faces, in mm2.
    pub area: f64,
    /// Centre of the volume or of the faces' area, in mm.
    pub centre: [f64; 3],
    /// Smallest corner of the tight box, in mm.
    pub min: [f64; 3],
    /// Largest corner of the tight box, in mm.
    pub max: [f64; 3],
    /// The chosen faces, in the kernel's order; none for a whole part.
    pub faces: Vec<Looked>,
}

/// A face that was looked at.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Looked {
    /// The surface's name, such as `PLANE` or `CYLINDER`.
    pub form: String,
    /// The outward normal of a plane face, or the axis of a cylinder, a cone or a torus, in the world.
    pub direction: Option<[f64; 3]>,
}
