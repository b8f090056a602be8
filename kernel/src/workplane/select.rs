//! Which shapes a selector means.

use std::rc::Rc;

use assemcad_model::selector::{Key, Selector};

use super::value::Vector;
use crate::brep::{Form, Topology};
use crate::error::{KernelError, Result};
use crate::shape::Shape;

/// How far, in mm or as an angle in radians, two things may differ that count as one: CadQuery's.
const TOLERANCE: f64 = 1e-4;

/// Those of `shapes` that the selector means, in their order; in the order of the key for a place
/// among several.
///
/// # Errors
/// When a place is asked for that does not exist, or a fact of a shape cannot be found.
pub(crate) fn select(selector: &Selector, shapes: &[Rc<Shape>]) -> Result<Vec<Rc<Shape>>> {
    match selector {
        Selector::Parallel(direction) => {
            let along = Vector::from(*direction);
            directed(shapes, |v| along.cross(v).norm() < TOLERANCE)
        }
        Selector::Along(direction) => {
            let along = Vector::from(*direction);
            directed(shapes, |v| angle(&along, v) < TOLERANCE)
        }
        Selector::Perpendicular(direction) => {
            let along = Vector::from(*direction);
            let right = core::f64::consts::FRAC_PI_2;
            directed(shapes, |v| (angle(&along, v) - right).abs() < TOLERANCE)
        }
        Selector::Form(name) => keep(shapes, |shape| Ok(shape.form()?.name() == name)),
        Selector::Nth {
            key,
            index,
            ascending,
        } => nth(shapes, key, *index, *ascending),
        Selector::Nearest(point) => nearest(shapes, &Vector::from(*point)),
        Selector::Box { from, to, whole } => keep(shapes, |shape| {
            let inside = |p: [f64; 3]| {
                p.iter()
                    .zip(from.iter().zip(to))
                    .all(|(x, (a, b))| (x < a) != (x < b))
            };
            if *whole {
                let extent = shape.extent()?;
                Ok(inside(extent.min) && inside(extent.max))
            } else {
                Ok(inside(shape.center()?))
            }
        }),
        Selector::And(a, b) => {
            let (a, b) = (select(a, shapes)?, select(b, shapes)?);
            Ok(a.into_iter().filter(|x| among(x, &b)).collect())
        }
        Selector::Or(a, b) => {
            let (a, b) = (select(a, shapes)?, select(b, shapes)?);
            Ok(distinct(a.into_iter().chain(b)))
        }
        Selector::Except(a, b) => {
            let (a, b) = (select(a, shapes)?, select(b, shapes)?);
            Ok(a.into_iter().filter(|x| !among(x, &b)).collect())
        }
        Selector::Not(a) => {
            let a = select(a, shapes)?;
            Ok(shapes.iter().filter(|x| !among(x, &a)).cloned().collect())
        }
    }
}

fn among(shape: &Shape, of: &[Rc<Shape>]) -> bool {
    of.iter().any(|other| other.same(shape))
}

/// Each shape once, in the order of its first coming.
pub(super) fn distinct(shapes: impl IntoIterator<Item = Rc<Shape>>) -> Vec<Rc<Shape>> {
    let mut found: Vec<Rc<Shape>> = Vec::new();
    for shape in shapes {
        if !among(&shape, &found) {
            found.push(shape);
        }
    }
    found
}

fn keep(
    shapes: &[Rc<Shape>],
    mut test: impl FnMut(&Shape) -> Result<bool>,
) -> Result<Vec<Rc<Shape>>> {
    let mut found = Vec::new();
    for shape in shapes {
        if test(shape)? {
            found.push(Rc::clone(shape));
        }
    }
    Ok(found)
}

/// The direction of a plane face (its normal) or a straight edge; nothing else has one.
fn direction(shape: &Shape) -> Result<Option<Vector>> {
    match (shape.topology()?, shape.form()?) {
        (Topology::Face, Form::Plane) => Ok(Some(shape.normal_at(None)?.into())),
        (Topology::Edge, Form::Line) => Ok(Some(shape.tangent_at(0.0)?.into())),
        _ => Ok(None),
    }
}

fn directed(shapes: &[Rc<Shape>], test: impl Fn(&Vector) -> bool) -> Result<Vec<Rc<Shape>>> {
    keep(shapes, |shape| {
        Ok(direction(shape)?.is_some_and(|v| test(&v)))
    })
}

/// The angle between two directions, 0 to pi.
fn angle(a: &Vector, b: &Vector) -> f64 {
    libm::atan2(a.cross(b).norm(), a.dot(b))
}

fn nth(shapes: &[Rc<Shape>], key: &Key, index: i32, ascending: bool) -> Result<Vec<Rc<Shape>>> {
    let mut keyed = Vec::new();
    for shape in shapes {
        if let Some(value) = value(shape, key)? {
            keyed.push((value, Rc::clone(shape)));
        }
    }
    // Equal keys keep the kernel's order.
    keyed.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut groups: Vec<(f64, Vec<Rc<Shape>>)> = Vec::new();
    for (value, shape) in keyed {
        match groups.last_mut() {
            Some((first, group)) if (value - *first).abs() <= TOLERANCE => group.push(shape),
            _ => groups.push((value, vec![shape])),
        }
    }
    if !ascending {
        groups.reverse();
    }
    let count = groups.len();
    let place = if index < 0 {
        count.checked_sub(usize::try_from(index.unsigned_abs()).unwrap_or(usize::MAX))
    } else {
        usize::try_from(index).ok()
    };
    place
        .and_then(|place| groups.into_iter().nth(place))
        .map(|(_, group)| group)
        .ok_or_else(|| {
            KernelError::refused(match count {
                0 => "the selector has nothing to choose among".to_owned(),
                n => format!("the selector asks for place {index} of {n}"),
            })
        })
}

/// What a shape is ordered by; none where the key has no meaning for it.
fn value(shape: &Shape, key: &Key) -> Result<Option<f64>> {
    let kind = shape.topology()?;
    Ok(match key {
        Key::Center(along) => Some(Vector::from(*along).dot(&Vector::from(shape.center()?))),
        Key::ParallelCenter(along) => {
            let along = Vector::from(*along);
            match direction(shape)? {
                Some(v) if along.cross(&v).norm() < TOLERANCE => {
                    Some(along.dot(&Vector::from(shape.center()?)))
                }
                _ => None,
            }
        }
        Key::Radius => match kind {
            // A curve that is no circle has no radius: that is no fault.
            Topology::Edge | Topology::Wire => shape.radius().ok(),
            _ => None,
        },
        Key::Length => match kind {
            Topology::Edge | Topology::Wire => Some(shape.measure()?.length),
            _ => {
                return Err(KernelError::refused(
                    "only edges and wires are ordered by their length",
                ));
            }
        },
        Key::Area => match kind {
            Topology::Face | Topology::Shell | Topology::Solid => Some(shape.measure()?.area),
            Topology::Wire => Shape::face(shape, &[])
                .and_then(|face| face.measure())
                .ok()
                .map(|m| m.area),
            _ => {
                return Err(KernelError::refused(
                    "only faces, shells, solids and closed wires are ordered by their area",
                ));
            }
        },
    })
}

fn nearest(shapes: &[Rc<Shape>], point: &Vector) -> Result<Vec<Rc<Shape>>> {
    let mut best: Option<(f64, &Rc<Shape>)> = None;
    for shape in shapes {
        let distance = (Vector::from(shape.center()?) - point).norm();
        if best.is_none_or(|(least, _)| distance < least) {
            best = Some((distance, shape));
        }
    }
    Ok(best
        .map(|(_, shape)| Rc::clone(shape))
        .into_iter()
        .collect())
}
