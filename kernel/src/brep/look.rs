//! What can be asked of a shape of any kind.

use assemcad_model::frame::{Frame, Placement};

use super::ffi::bridge;
use crate::error::{Context, KernelError, Result};
use crate::limits::coordinates;
use crate::pair;
use crate::query::Bounds;
use crate::shape::Shape;

/// What sort of surface, curve or shape it is: CadQuery's `geomType`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Form {
    /// A flat face.
    Plane,
    /// A cylindrical face.
    Cylinder,
    /// A conical face.
    Cone,
    /// A spherical face.
    Sphere,
    /// A toroidal face.
    Torus,
    /// A Bezier surface or curve.
    Bezier,
    /// A B-spline surface or curve.
    BSpline,
    /// A surface of revolution of another sort.
    Revolution,
    /// A surface of extrusion of another sort.
    Extrusion,
    /// An offset surface or curve.
    Offset,
    /// A straight edge.
    Line,
    /// A circle or an arc of one.
    Circle,
    /// An ellipse or an arc of one.
    Ellipse,
    /// A piece of a hyperbola.
    Hyperbola,
    /// A piece of a parabola.
    Parabola,
    /// A vertex.
    Vertex,
    /// A wire.
    Wire,
    /// A shell.
    Shell,
    /// A solid.
    Solid,
    /// Solids that share faces.
    CompSolid,
    /// A group.
    Compound,
    /// Any other surface or curve.
    Other,
}

impl Form {
    /// CadQuery's word for it: upper-case for surfaces and curves, such as `PLANE`, else the kind of
    /// shape, such as `Wire`.
    #[must_use]
    pub fn name(&self) -> &'static str {
        match self {
            Self::Plane => "PLANE",
            Self::Cylinder => "CYLINDER",
            Self::Cone => "CONE",
            Self::Sphere => "SPHERE",
            Self::Torus => "TORUS",
            Self::Bezier => "BEZIER",
            Self::BSpline => "BSPLINE",
            Self::Revolution => "REVOLUTION",
            Self::Extrusion => "EXTRUSION",
            Self::Offset => "OFFSET",
            Self::Line => "LINE",
            Self::Circle => "CIRCLE",
            Self::Ellipse => "ELLIPSE",
            Self::Hyperbola => "HYPERBOLA",
            Self::Parabola => "PARABOLA",
            Self::Vertex => "Vertex",
            Self::Wire => "Wire",
            Self::Shell => "Shell",
            Self::Solid => "Solid",
            Self::CompSolid => "CompSolid",
            Self::Compound => "Compound",
            Self::Other => "OTHER",
        }
    }

    /// From the numbers of `form_of` in `cpp/look.cpp`.
    fn from_code(code: u8) -> Self {
        match code {
            0 => Self::Plane,
            1 => Self::Cylinder,
            2 => Self::Cone,
            3 => Self::Sphere,
            4 => Self::Torus,
            5 | 25 => Self::Bezier,
            6 | 26 => Self::BSpline,
            7 => Self::Revolution,
            8 => Self::Extrusion,
            9 | 27 => Self::Offset,
            20 => Self::Line,
            21 => Self::Circle,
            22 => Self::Ellipse,
            23 => Self::Hyperbola,
            24 => Self::Parabola,
            40 => Self::Compound,
            41 => Self::CompSolid,
            42 => Self::Solid,
            43 => Self::Shell,
            45 => Self::Wire,
            47 => Self::Vertex,
            _ => Self::Other,
        }
    }
}

/// How large a shape is; what does not apply to its kind is 0.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Measure {
    /// The length of its edges in mm, for shapes without faces.
    pub length: f64,
    /// The area of its faces in mm2.
    pub area: f64,
    /// The volume of its solids in mm3; negative for a solid that is inside-out.
    pub volume: f64,
}

impl Shape {
    /// What sort of surface, curve or shape it is.
    ///
    /// # Errors
    /// For an edge without a curve.
    pub fn form(&self) -> Result<Form> {
        bridge::form_of(self.solid()?)
            .map(Form::from_code)
            .context(|| "the sort of the shape could not be told".into())
    }

    fn weighed(&self) -> Result<bridge::CenterRaw> {
        let raw = bridge::center_of(self.solid()?)
            .context(|| "the centre of the shape could not be found".into())?;
        if raw.center.iter().chain([&raw.mass]).all(|n| n.is_finite()) {
            Ok(raw)
        } else {
            Err(KernelError::invalid(
                "the centre of the shape could not be found: it is not finite",
            ))
        }
    }

    /// The centre in mm: of the length of edges and wires, the area of faces and shells, the volume of
    /// solids; a compound is weighed as its first part is, and a vertex is its point.
    ///
    /// # Errors
    /// For a group of vertices, and when the kernel fails.
    pub fn center(&self) -> Result<[f64; 3]> {
        self.weighed().map(|raw| raw.center)
    }

    /// The centre of several shapes in mm, each weighed by its own length, area or volume.
    ///
    /// # Errors
    /// When there is nothing that weighs anything.
    pub fn combined_center(shapes: &[&Self]) -> Result<[f64; 3]> {
        let mut mass = 0.0;
        let mut sum = [0.0; 3];
        for shape in shapes {
            let raw = shape.weighed()?;
            mass += raw.mass;
            for (s, c) in sum.iter_mut().zip(raw.center) {
                *s += raw.mass * c;
            }
        }
        if mass == 0.0 {
            return Err(KernelError::refused(
                "the shapes have no common centre: none of them has a length, an area or a volume",
            ));
        }
        Ok(sum.map(|s| s / mass))
    }

    /// The centre of the box about the shape in mm.
    ///
    /// # Errors
    /// When the shape is empty.
    pub fn box_center(&self) -> Result<[f64; 3]> {
        let Bounds {
            min: [a, b, c],
            max: [d, e, f],
        } = self.extent()?;
        Ok([(a + d) / 2.0, (b + e) / 2.0, (c + f) / 2.0])
    }

    /// The tight box about a shape of any kind in mm, without the kernel's tolerances (1e-7 mm), which
    /// CadQuery's `BoundingBox` has around it.
    ///
    /// # Errors
    /// When the shape is empty.
    pub fn extent(&self) -> Result<Bounds> {
        self.bounds()
    }

    /// The unit normal: of a face out of the material, in the middle of its parameters or where it is
    /// nearest to `near` (mm); of a wire or edge that of the plane it lies in.
    ///
    /// # Errors
    /// When the curve is in no plane or in many, or the face has no normal there.
    pub fn normal_at(&self, near: Option<[f64; 3]>) -> Result<[f64; 3]> {
        if let Some(point) = &near {
            coordinates("point", point)?;
        }
        let near = near.as_ref().map_or(&[] as &[f64], |point| point);
        bridge::normal_of(self.solid()?, near)
            .context(|| "the normal of the shape could not be found".into())
    }

    /// How long, wide and large the shape is.
    ///
    /// # Errors
    /// When a number comes out that is not finite.
    pub fn measure(&self) -> Result<Measure> {
        let bridge::MeasureRaw {
            length,
            area,
            volume,
        } = bridge::measure_of(self.solid()?)
            .context(|| "the shape could not be measured".into())?;
        if [length, area, volume].iter().any(|n| !n.is_finite()) {
            return Err(KernelError::invalid(
                "the shape could not be measured: a number is not finite",
            ));
        }
        Ok(Measure {
            length,
            area,
            volume,
        })
    }

    /// The plane of a flat face as its surface states it: its z may point into the material.
    ///
    /// # Errors
    /// When it is no flat face.
    pub fn plane_of(&self) -> Result<Placement> {
        let raw = bridge::plane_of(self.solid()?)
            .context(|| "the plane of the shape could not be found".into())?;
        Frame::new(raw.origin, raw.z, raw.x)
            .and_then(|frame| frame.placement())
            .map_err(|e| KernelError::internal(e.to_string()))
    }

    /// The least distance to another shape in mm, with a point on each that has it.
    ///
    /// # Errors
    /// When the kernel fails.
    pub fn distance_to(&self, other: &Self) -> Result<(f64, [f64; 3], [f64; 3])> {
        let here = Placement::IDENTITY;
        let found = pair::distance(self, &here, other, &here)?;
        Ok((found.distance, found.on_a, found.on_b))
    }

    /// Whether the kernel's own check has nothing against the shape.
    ///
    /// # Errors
    /// When the check itself fails.
    pub fn is_valid(&self) -> Result<bool> {
        bridge::valid_shape(self.solid()?).context(|| "the shape could not be checked".into())
    }
}
