//! Over how much area two solids touch in a stated surface, from their skins.

use assemcad_kernel::contact::{TOUCH_MM, Touch, Where};
use assemcad_model::frame::Placement;

use super::boundary::Boundary;
use super::patch::{Edge, Patch, Surface, V, across};
use super::region::{Curve, P, Region, common_area};

/// How far directions may be from each other, in radians: what the kernel's own contact takes.
const TOUCH_RAD: f64 = 1e-6;

/// The contact of two solids, the second placed in the frame of the first; none where one of the faces is bounded
/// by other curves than lines and circles, and the kernel has to be asked.
#[must_use]
pub fn touch(a: &Boundary, b: &Boundary, at: &Placement, place: &Where) -> Option<Touch> {
    let whole = Placement::IDENTITY;
    let (on_a, on_b) = (sheets(a, &whole, place), sheets(b, at, place));
    let mut out = Touch {
        faces_a: u32::try_from(on_a.len()).ok()?,
        faces_b: u32::try_from(on_b.len()).ok()?,
        ..Touch::default()
    };
    for one in &on_a {
        for two in &on_b {
            if (one.radius - two.radius).abs() > TOUCH_MM || one.towards == two.towards {
                continue;
            }
            out.area += match place {
                Where::Plane { point, normal } => {
                    let axes = Axes::of(point, normal)?;
                    common_area(&flat(&one.patch, &axes)?, &flat(&two.patch, &axes)?)
                }
                Where::Axis { point, direction } => {
                    let along = (V::from(*point), V::from(*direction));
                    let (low, high) = overlap(full(&one.patch, &along)?, full(&two.patch, &along)?);
                    core::f64::consts::TAU * one.radius * (high - low).max(0.0)
                }
            };
        }
    }
    Some(out)
}

/// A face in the stated surface.
struct Sheet<'a> {
    patch: Patch<'a>,
    /// 0 for a plane.
    radius: f64,
    /// Whether its normal looks along the stated one, or towards the axis.
    towards: bool,
}

fn sheets<'a>(of: &'a Boundary, at: &'a Placement, place: &Where) -> Vec<Sheet<'a>> {
    let faces = of.skin().faces.iter();
    faces
        .filter_map(|face| {
            let patch = Patch::face(of, at, face);
            let (radius, towards) = lies(&patch, place)?;
            Some(Sheet {
                patch,
                radius,
                towards,
            })
        })
        .collect()
}

fn lies(patch: &Patch<'_>, place: &Where) -> Option<(f64, bool)> {
    match (&patch.surface, place) {
        (
            Surface::Plane { origin, normal },
            Where::Plane {
                point,
                normal: wanted,
            },
        ) => {
            let wanted = V::from(*wanted);
            let flat = normal.cross(&wanted).norm() <= TOUCH_RAD
                && (origin - V::from(*point)).dot(&wanted).abs() <= TOUCH_MM;
            flat.then(|| (0.0, normal.dot(&wanted) > 0.0))
        }
        (
            Surface::Round {
                origin,
                axis,
                radius,
                slope,
                ..
            },
            Where::Axis { point, direction },
        ) if *slope == 0.0 => {
            let wanted = V::from(*direction);
            let off = across(&(origin - V::from(*point)), &wanted).norm();
            (axis.cross(&wanted).norm() <= TOUCH_RAD && off <= TOUCH_MM)
                .then_some((*radius, patch.hollow()))
        }
        _ => None,
    }
}

/// Axes of a plane.
pub(super) struct Axes {
    pub(super) origin: V,
    pub(super) x: V,
    pub(super) y: V,
}

impl Axes {
    fn of(point: &[f64; 3], normal: &[f64; 3]) -> Option<Self> {
        let normal = V::from(*normal);
        // Across the world's axis that is least along the normal.
        let least = normal.iamin();
        let mut other = V::zeros();
        *other.get_mut(least)? = 1.0;
        let x = normal.cross(&other).try_normalize(1e-6)?;
        Some(Self {
            origin: V::from(*point),
            x,
            y: normal.cross(&x),
        })
    }

    pub(super) fn flat(&self, p: &V) -> P {
        let arm = p - self.origin;
        P::new(arm.dot(&self.x), arm.dot(&self.y))
    }
}

/// The border of a plane face.
pub(super) fn flat(patch: &Patch<'_>, axes: &Axes) -> Option<Region> {
    let curve = |edge: Edge| match edge {
        Edge::Line(from, to) => Some(Curve::Line {
            from: axes.flat(&from),
            to: axes.flat(&to),
        }),
        Edge::Circle {
            center,
            axis,
            radius,
            start,
            sweep,
        } => {
            let (center, first) = (axes.flat(&center), axes.flat(&start));
            let arm = first - center;
            let from = libm::atan2(arm.y, arm.x);
            // Seen from below the arc runs clockwise: from its other end it is counter-clockwise.
            let from = match axis.dot(&axes.x.cross(&axes.y)) > 0.0 {
                true => from,
                false => from - sweep,
            };
            Some(Curve::Arc {
                center,
                radius,
                from,
                sweep,
            })
        }
        Edge::Unknown => None,
    };
    patch.borders().map(curve).collect()
}

/// From where to where along an axis a cylinder goes that goes all the way round; none of another one.
fn full(patch: &Patch<'_>, (point, along): &(V, V)) -> Option<(f64, f64)> {
    let mut ends = Vec::new();
    let mut seams = 0;
    for edge in patch.borders() {
        match edge {
            Edge::Line(..) => seams += 1,
            Edge::Circle { center, sweep, .. } if sweep >= core::f64::consts::TAU - 1e-6 => {
                ends.push((center - point).dot(along));
            }
            _ => return None,
        }
    }
    // One seam, which bounds it on both sides, and a circle at each end.
    match (ends.as_slice(), seams) {
        ([a, b], 2) => Some((a.min(*b), a.max(*b))),
        _ => None,
    }
}

fn overlap(a: (f64, f64), b: (f64, f64)) -> (f64, f64) {
    (a.0.max(b.0), a.1.min(b.1))
}
