//! The solids of a picture: each part whole or cut, and what two parts have in common.

use std::collections::BTreeMap;
use std::sync::Arc;

use assemcad_factories::failure::diagnostic;
use assemcad_geometry::{Asker, PlacedSolid};
use assemcad_kernel::asked::Body;
use assemcad_kernel::protocol::{Instance, Product};
use assemcad_model::diagnostic::Diagnostic;
use assemcad_model::frame::Placement;
use assemcad_placing::{Box3, Partial};
use assemcad_render::Surface;
use futures::future::join_all;

use super::meshes::surface;
use super::wanted::Section;

/// A surface, nothing, or why it is not known.
pub(super) type Found = Result<Option<Arc<Surface>>, Diagnostic>;

/// The solids of the parts and where they are, as the STEP file would have them.
pub(super) struct Solids<'a> {
    pub(super) part: &'a Partial,
    pub(super) products: &'a [Product],
    pub(super) instances: &'a [Instance],
    pub(super) boxes: &'a [Option<Box3>],
    /// How fine the triangles are, in mm.
    pub(super) deflection: f64,
}

/// A section and the side that is taken away: of larger coordinates, or of smaller ones.
pub(super) type Side = (Section, bool);

impl Solids<'_> {
    /// What is asked for a part; none where nothing of it is left.
    fn asked(&self, i: usize, side: Option<Side>) -> Option<(String, Body)> {
        let solid = self.instances.get(i)?.solid;
        let recipe = self.products.get(solid)?.recipe.clone();
        let at = self.part.placements.of(i)?;
        let whole = (
            format!("{solid}"),
            Body::Whole {
                recipe: recipe.clone(),
            },
        );
        let Some((section, upper)) = side else {
            return Some(whole);
        };
        let (min, max) = self.boxes.get(i)?.as_ref()?;
        let (low, high) = (*min.get(section.axis)?, *max.get(section.axis)?);
        let (from, to) = if upper { (low, high) } else { (-high, -low) };
        let level = if upper {
            section.offset_mm
        } else {
            -section.offset_mm
        };
        if to <= level {
            return Some(whole);
        }
        if from >= level {
            return None;
        }
        let (mut point, mut normal) = ([0.0; 3], [0.0; 3]);
        *point.get_mut(section.axis)? = section.offset_mm;
        *normal.get_mut(section.axis)? = if upper { 1.0 } else { -1.0 };
        let back = at.inverse();
        let (point, normal) = (back.point(point), back.direction(normal));
        Some((
            format!("part {i}"),
            Body::Behind {
                recipe,
                point,
                normal,
            },
        ))
    }

    /// The surfaces of all placed parts, in their order.
    pub(super) async fn surfaces(&self, door: Asker<'_>, side: Option<Side>) -> Vec<Found> {
        let asked: Vec<Option<(String, Body)>> = (0..self.instances.len())
            .map(|i| self.asked(i, side))
            .collect();
        // Equal parts are made once.
        let mut distinct: BTreeMap<&str, (&Body, String)> = BTreeMap::new();
        for (found, instance) in asked.iter().zip(self.instances) {
            if let Some((key, body)) = found {
                let place = format!("part '{}'", instance.name);
                distinct.entry(key).or_insert((body, place));
            }
        }
        let made = join_all(distinct.iter().map(|(key, (body, place))| async move {
            let surface = surface(door, (*body).clone(), self.deflection, place);
            (*key, surface.await)
        }))
        .await;
        let made: BTreeMap<&str, Found> = made.into_iter().collect();
        let of = |found: &Option<(String, Body)>| match found {
            Some((key, _)) => made.get(key.as_str()).cloned().unwrap_or(Ok(None)),
            None => Ok(None),
        };
        asked.iter().map(of).collect()
    }

    /// A part's solid in its place.
    pub(super) fn solid(&self, i: usize) -> Option<PlacedSolid> {
        let at = self.part.placements.of(i)?;
        Some(self.part.resolved.parts.get(i)?.solid_at(&at))
    }
}

/// The common part of two placed parts in the world, and its volume in mm3.
pub(super) struct Common {
    pub(super) surface: Arc<Surface>,
    pub(super) volume: f64,
}

/// What two placed parts have in common; none where they do not overlap.
pub(super) async fn common_solid(
    door: Asker<'_>,
    a: PlacedSolid,
    b: PlacedSolid,
    deflection: f64,
) -> Result<Option<Common>, Diagnostic> {
    let place = "the common part";
    let common = door.common_volume(&a, &b, 1).await;
    let volume = common.map_err(|f| diagnostic(&f, place))?.volume;
    let shared = Body::Shared {
        a: Box::new(a.into()),
        b: Box::new(b.into()),
    };
    let surface = surface(door, shared, deflection, place).await?;
    Ok(surface.map(|surface| Common { surface, volume }))
}

/// The placement moved in the world.
pub(super) fn shifted(at: &Placement, by: [f64; 3]) -> Placement {
    let [x, y, z] = by;
    Placement::translation(x, y, z) * *at
}
