//! What a shape is made of, and shapes moved as they are.

use assemcad_model::frame::Placement;

use super::ffi::bridge;
use super::{bundle, made, unbundle};
use crate::error::{Context, KernelError, Result};
use crate::limits::{coordinates, direction};
use crate::shape::{Shape, pose};

/// The kinds of shapes, from the most to the least composed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Topology {
    /// A group of any shapes.
    Compound,
    /// Solids that share faces.
    CompSolid,
    /// A body.
    Solid,
    /// Faces that hang together.
    Shell,
    /// A bounded piece of a surface.
    Face,
    /// Edges that hang together.
    Wire,
    /// A bounded piece of a curve.
    Edge,
    /// A point.
    Vertex,
}

impl Topology {
    /// Every kind, in OCCT's order of them.
    const ALL: [Self; 8] = [
        Self::Compound,
        Self::CompSolid,
        Self::Solid,
        Self::Shell,
        Self::Face,
        Self::Wire,
        Self::Edge,
        Self::Vertex,
    ];

    fn code(self) -> u8 {
        match self {
            Self::Compound => 0,
            Self::CompSolid => 1,
            Self::Solid => 2,
            Self::Shell => 3,
            Self::Face => 4,
            Self::Wire => 5,
            Self::Edge => 6,
            Self::Vertex => 7,
        }
    }

    /// CadQuery's word for it, such as `Face`.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Compound => "Compound",
            Self::CompSolid => "CompSolid",
            Self::Solid => "Solid",
            Self::Shell => "Shell",
            Self::Face => "Face",
            Self::Wire => "Wire",
            Self::Edge => "Edge",
            Self::Vertex => "Vertex",
        }
    }
}

impl Shape {
    /// The kind of the shape.
    ///
    /// # Errors
    /// When the kernel fails.
    pub fn topology(&self) -> Result<Topology> {
        let code = bridge::kind_of(self.solid()?)
            .context(|| "the kind of the shape could not be told".into())?;
        Topology::ALL
            .get(usize::from(code))
            .copied()
            .ok_or_else(|| KernelError::internal("the kernel named an unknown kind of shape"))
    }

    /// The distinct parts of one kind, in the kernel's order, which is the same for the same shape; a
    /// shape of that very kind is its own part.
    ///
    /// Edges that are a point (the pole of a sphere) are left out, and the vertices of a wire come in
    /// the order in which it is walked, both as in CadQuery.
    ///
    /// # Errors
    /// When the kernel fails.
    pub fn parts(&self, of: Topology) -> Result<Vec<Self>> {
        unbundle(bridge::parts_of(self.solid()?, of.code()), || {
            "the parts of the shape could not be listed".into()
        })
    }

    /// Those parts of this shape of kind `kind` that hold `of`, each once.
    ///
    /// # Errors
    /// When `of` is no part of this shape, or `kind` is not above its kind.
    pub fn ancestors(&self, of: &Self, kind: Topology) -> Result<Vec<Self>> {
        unbundle(
            bridge::ancestors_of(self.solid()?, of.solid()?, kind.code()),
            || "what holds the shape could not be found".into(),
        )
    }

    /// The direct children: of a compound what was put into it, of a solid its shells, of a wire its
    /// edges in the order in which it is walked.
    ///
    /// # Errors
    /// When the kernel fails.
    pub fn children(&self) -> Result<Vec<Self>> {
        unbundle(bridge::children_of(self.solid()?), || {
            "the children of the shape could not be listed".into()
        })
    }

    /// Shapes as one group, which may be empty; nothing is joined.
    ///
    /// # Errors
    /// When the kernel fails.
    pub fn compound(shapes: &[&Self]) -> Result<Self> {
        made(bridge::compound_of(&*bundle(shapes)?), || {
            "the shapes could not be grouped".into()
        })
    }

    /// Whether both are one and the same piece of geometry at the same place, the way round aside.
    #[must_use]
    pub fn same(&self, other: &Self) -> bool {
        match (self.solid(), other.solid()) {
            (Ok(a), Ok(b)) => bridge::same_shape(a, b),
            _ => false,
        }
    }

    /// Another handle to the same shape.
    ///
    /// # Errors
    /// When the kernel fails.
    pub fn try_clone(&self) -> Result<Self> {
        made(bridge::another_handle(self.solid()?), || {
            "the shape could not be copied".into()
        })
    }

    /// The shape at another place, cheaply: the geometry is shared, a location is put on it.
    ///
    /// # Errors
    /// When the placement is not rigid or a number is out of range.
    pub fn moved(&self, at: &Placement) -> Result<Self> {
        made(bridge::shape_moved(self.solid()?, &pose(at)?), || {
            "the shape could not be moved".into()
        })
    }

    /// The shape with its geometry written anew where locations were.
    ///
    /// # Errors
    /// When the kernel fails.
    pub fn baked(&self) -> Result<Self> {
        made(bridge::shape_baked(self.solid()?), || {
            "the shape could not be written anew at its place".into()
        })
    }

    /// The mirror image in the plane through `point` across `normal`, a copy of its own.
    ///
    /// # Errors
    /// When the normal has no length or a number is out of range.
    pub fn mirrored(&self, point: [f64; 3], normal: [f64; 3]) -> Result<Self> {
        coordinates("point of the mirror plane", &point)?;
        direction("normal of the mirror plane", &normal)?;
        made(
            bridge::shape_mirrored(self.solid()?, &point, &normal),
            || "the shape could not be mirrored".into(),
        )
    }
}
