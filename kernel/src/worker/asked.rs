//! The jobs that pictures and measurements ask for.

use std::rc::Rc;

use assemcad_model::frame::Placement;
use assemcad_workers::Tell;

use super::jobs::{Bench, Solid, doing};
use crate::asked::{Body, Chosen, Looked, Measured};
use crate::brep::Topology;
use crate::error::{KernelError, Result};
use crate::facts::Surface;
use crate::mesh::Mesh;
use crate::pair::{self, Distance};
use crate::protocol::Reply;
use crate::section;
use crate::shape::Shape;
use crate::workplane::select;

impl Bench {
    pub(super) fn tessellate(
        &mut self,
        body: &Body,
        deflection: f64,
        angle_deg: f64,
        tell: Tell<'_>,
    ) -> Result<(Reply, Vec<u8>)> {
        let mesh = match body {
            Body::Whole { recipe } => {
                let (hash, solid, _) = self.solid(recipe, tell)?;
                tell(doing("triangles", Some(hash)));
                Some(solid.triangles(deflection, angle_deg)?)
            }
            Body::Behind {
                recipe,
                point,
                normal,
            } => {
                let (hash, solid, _) = self.solid(recipe, tell)?;
                tell(doing("section", Some(hash)));
                let left = section::behind(&solid.shape, *point, *normal)?;
                left.map(|s| s.mesh(deflection, angle_deg).map(Rc::new))
                    .transpose()?
            }
            Body::Shared { a, b } => {
                let (_, solid_a, _) = self.solid(&a.recipe, tell)?;
                let (_, solid_b, _) = self.solid(&b.recipe, tell)?;
                tell(doing("common part", None));
                let (at_a, at_b) = (Placement::from(a.placement), Placement::from(b.placement));
                let both = section::shared(&solid_a.shape, &at_a, &solid_b.shape, &at_b)?;
                both.map(|s| s.mesh(deflection, angle_deg).map(Rc::new))
                    .transpose()?
            }
        };
        let bytes = mesh.as_ref().map(|m| m.to_bytes()).transpose()?;
        let some = bytes.is_some();
        Ok((Reply::Mesh { some }, bytes.unwrap_or_default()))
    }

    pub(super) fn measure(&mut self, of: &Chosen, tell: Tell<'_>) -> Result<Measured> {
        let at = Placement::from(of.part.placement);
        let (hash, solid, _) = self.solid(&of.part.recipe, tell)?;
        tell(doing("measurement", Some(hash)));
        let Some(faces) = chosen(&solid, of)? else {
            let (mass, bounds) = (solid.shape.mass()?, solid.shape.bounds_at(&at)?);
            return Ok(Measured {
                volume: Some(mass.volume),
                area: mass.area,
                centre: at.point(mass.center),
                min: bounds.min,
                max: bounds.max,
                faces: Vec::new(),
            });
        };
        let group = together(&faces)?;
        let handles: Vec<&Shape> = faces.iter().map(AsRef::as_ref).collect();
        let bounds = group.bounds_at(&at)?;
        let looked: Result<Vec<Looked>> = faces.iter().map(|face| look(face, &at)).collect();
        Ok(Measured {
            volume: None,
            area: group.measure()?.area,
            centre: at.point(Shape::combined_center(&handles)?),
            min: bounds.min,
            max: bounds.max,
            faces: looked?,
        })
    }

    pub(super) fn distance(&mut self, a: &Chosen, b: &Chosen, tell: Tell<'_>) -> Result<Distance> {
        let (_, solid_a, _) = self.solid(&a.part.recipe, tell)?;
        let (_, solid_b, _) = self.solid(&b.part.recipe, tell)?;
        tell(doing("smallest distance", None));
        let (at_a, at_b) = (
            Placement::from(a.part.placement),
            Placement::from(b.part.placement),
        );
        let (one, two) = (meant(&solid_a, a)?, meant(&solid_b, b)?);
        pair::distance(&one, &at_a, &two, &at_b)
    }
}

impl Solid {
    /// The solid's triangles, kept until others are asked for.
    fn triangles(&self, deflection: f64, angle_deg: f64) -> Result<Rc<Mesh>> {
        let wanted = (deflection, angle_deg);
        if let Some((fineness, mesh)) = self.mesh.borrow().as_ref()
            && *fineness == wanted
        {
            return Ok(Rc::clone(mesh));
        }
        let mesh = Rc::new(self.shape.mesh(deflection, angle_deg)?);
        *self.mesh.borrow_mut() = Some((wanted, Rc::clone(&mesh)));
        Ok(mesh)
    }
}

/// The faces that are meant; none for the whole part.
fn chosen(solid: &Solid, of: &Chosen) -> Result<Option<Vec<Rc<Shape>>>> {
    let Some(selector) = &of.faces else {
        return Ok(None);
    };
    let all: Vec<Rc<Shape>> = solid
        .shape
        .parts(Topology::Face)?
        .into_iter()
        .map(Rc::new)
        .collect();
    let faces = select(selector, &all)?;
    if faces.is_empty() {
        return Err(KernelError::refused(format!(
            "the selector means none of the part's {} faces",
            all.len()
        )));
    }
    Ok(Some(faces))
}

fn together(faces: &[Rc<Shape>]) -> Result<Shape> {
    let faces: Vec<&Shape> = faces.iter().map(AsRef::as_ref).collect();
    Shape::compound(&faces)
}

/// The whole part or the faces that are meant, as one shape.
fn meant(solid: &Solid, of: &Chosen) -> Result<Shape> {
    match chosen(solid, of)? {
        Some(faces) => together(&faces),
        None => solid.shape.try_clone(),
    }
}

fn look(face: &Shape, at: &Placement) -> Result<Looked> {
    let facts = face.faces()?;
    let direction = match facts.first().map(|f| &f.surface) {
        Some(Surface::Plane { normal }) => Some(*normal),
        Some(
            Surface::Cylinder { axis, .. }
            | Surface::Cone { axis, .. }
            | Surface::Torus { axis, .. },
        ) => Some(*axis),
        _ => None,
    };
    Ok(Looked {
        form: face.form()?.name().to_owned(),
        direction: direction.map(|d| at.direction(d)),
    })
}
