//! Which edges a selector means, decided over the facts of the edges.

use assemcad_model::recipe::EdgeSelector;

use crate::error::{KernelError, Result};
use crate::facts::{Curve, Edge, Turn};
use crate::limits::{coordinates, direction};

/// How far, in mm, an edge may be from a plane it lies in.
const IN_PLANE: f64 = 1e-6;

/// How far, as a sine, a line may be from a direction it is parallel to.
const PARALLEL: f64 = 1e-6;

/// The positions of the edges that a selector means.
///
/// Only edges where two faces meet at an angle count: neither seams nor edges where faces run into
/// each other smoothly, such as the borders of a fillet.
///
/// # Errors
/// When the selector's numbers are no direction or point, or no edge is meant.
pub fn select(selector: &EdgeSelector, edges: &[Edge]) -> Result<Vec<u32>> {
    let test: Box<dyn Fn(&Edge) -> bool> = match selector {
        EdgeSelector::All => Box::new(|_| true),
        EdgeSelector::Parallel { direction } => {
            let along = unit("direction of the edge selector", direction)?;
            Box::new(move |e| {
                e.curve == Curve::Line && length(&cross(&along, &e.tangent)) <= PARALLEL
            })
        }
        EdgeSelector::InPlane { point, normal } => {
            let normal = unit("normal of the edge selector", normal)?;
            coordinates("edge selector's point", point)?;
            let level = dot(&normal, point);
            Box::new(move |e| {
                !e.samples.is_empty()
                    && e.samples
                        .iter()
                        .all(|p| (dot(&normal, p) - level).abs() <= IN_PLANE)
            })
        }
    };
    let found: Vec<u32> = edges
        .iter()
        .zip(0_u32..)
        .filter(|(e, _)| matches!(e.turn, Turn::Convex | Turn::Concave) && test(e))
        .map(|(_, i)| i)
        .collect();
    if found.is_empty() {
        return Err(KernelError::refused(match selector {
            EdgeSelector::All => "the solid has no edge where faces meet at an angle".to_owned(),
            EdgeSelector::Parallel { direction } => {
                format!("no straight edge of the solid is parallel to {direction:?}")
            }
            EdgeSelector::InPlane { point, normal } => {
                format!(
                    "no edge of the solid lies in the plane at {point:?} with normal {normal:?}"
                )
            }
        }));
    }
    Ok(found)
}

fn dot([a, b, c]: &[f64; 3], [x, y, z]: &[f64; 3]) -> f64 {
    a * x + b * y + c * z
}

fn cross([a, b, c]: &[f64; 3], [x, y, z]: &[f64; 3]) -> [f64; 3] {
    [b * z - c * y, c * x - a * z, a * y - b * x]
}

fn length(v: &[f64; 3]) -> f64 {
    dot(v, v).sqrt()
}

fn unit(what: &str, v: &[f64; 3]) -> Result<[f64; 3]> {
    direction(what, v)?;
    // By the largest component first: squares of tiny or huge numbers are lost.
    let largest = v.iter().fold(0.0_f64, |m, n| m.max(n.abs()));
    let v = v.map(|n| n / largest);
    let size = length(&v);
    Ok(v.map(|n| n / size))
}
