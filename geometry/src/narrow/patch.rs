//! Pieces of faces in the frame of the solid that they are held against, and bounds on where they reach.
//!
//! Each bound holds for every point of the piece: a lower bound is never too large, an upper bound never
//! too small. Where no bound is known there is none, and the question goes to the kernel.

use assemcad_kernel::facts::Turn;
use assemcad_kernel::skin::{SkinCurve, SkinFace, SkinSurface};
use assemcad_model::frame::Placement;
use nalgebra::Vector3;

use super::arc::Arc;
use super::boundary::Boundary;

/// Directions count as parallel or at right angles up to this sine or cosine: what placing leaves.
pub(super) const PARALLEL: f64 = 1e-10;

/// How far a point may be off a plane face whose triangles it is looked for in, in mm: more than rounding.
const COVER_MM: f64 = 1e-3;

/// A surface in the frame of another solid.
#[derive(Debug, Clone, Copy)]
pub(super) enum Surface {
    /// A plane and its normal out of the material.
    Plane { origin: V, normal: V },
    /// Round about an axis: a cylinder where the slope is 0, else a cone.
    Round {
        origin: V,
        axis: V,
        radius: f64,
        slope: f64,
        range: [f64; 2],
    },
    /// A sphere.
    Sphere { center: V, radius: f64 },
    /// A torus.
    Torus {
        center: V,
        axis: V,
        radius: f64,
        tube: f64,
    },
    /// Anything else.
    Other,
}

pub(super) type V = Vector3<f64>;

/// A face of a solid, or one triangle's piece of it, seen from another solid.
#[derive(Debug)]
pub(super) struct Patch<'a> {
    boundary: &'a Boundary,
    at: &'a Placement,
    pub(super) face: &'a SkinFace,
    pub(super) surface: Surface,
    /// The corners of the piece, where it is one triangle's.
    pub(super) corners: Option<[V; 3]>,
}

/// An edge of a face's border.
pub(super) enum Edge {
    Line(V, V),
    Circle {
        center: V,
        axis: V,
        radius: f64,
        start: V,
        sweep: f64,
    },
    Unknown,
}

impl<'a> Patch<'a> {
    /// A face of a solid that is placed somewhere.
    pub(super) fn face(boundary: &'a Boundary, at: &'a Placement, face: &'a SkinFace) -> Self {
        Self {
            boundary,
            at,
            face,
            surface: placed(&face.surface, at),
            corners: None,
        }
    }

    /// The piece of the face that belongs to one of its triangles, with these corners.
    pub(super) fn piece(&self, corners: [V; 3]) -> Self {
        Self {
            corners: Some(corners),
            ..*self
        }
    }

    /// Whether the surface is what the material surrounds, such as a hole.
    pub(super) fn hollow(&self) -> bool {
        !self.face.outward
    }

    /// The solid that the face belongs to, and where it is.
    pub(super) fn boundary(&self) -> &'a Boundary {
        self.boundary
    }

    pub(super) fn placement(&self) -> &'a Placement {
        self.at
    }

    /// The corners of one of its solid's triangles.
    pub(super) fn triangle(&self, index: u32) -> Option<[V; 3]> {
        let (.., own) = self.boundary.triangle(index)?;
        Some(own.map(|p| V::from(self.at.point(p.into()))))
    }

    pub(super) fn borders(&self) -> impl Iterator<Item = Edge> {
        self.borders_and_turns().map(|(edge, _)| edge)
    }

    /// The edges of the border, and whether each is an outer one.
    pub(super) fn borders_and_turns(&self) -> impl Iterator<Item = (Edge, bool)> {
        let edges = self.face.edges.iter().map(|e| self.boundary.edge(*e));
        edges.map(|edge| {
            let Some(edge) = edge else {
                return (Edge::Unknown, false);
            };
            let outer = edge.turn == Turn::Convex;
            let point = |p: [f64; 3]| V::from(self.at.point(p));
            let placed = match edge.curve {
                SkinCurve::Line => Edge::Line(point(edge.start), point(edge.end)),
                SkinCurve::Point => Edge::Line(point(edge.start), point(edge.start)),
                SkinCurve::Circle {
                    center,
                    axis,
                    radius,
                    sweep,
                } => Edge::Circle {
                    center: point(center),
                    axis: V::from(self.at.direction(axis)),
                    radius,
                    start: point(edge.start),
                    sweep,
                },
                SkinCurve::Other => Edge::Unknown,
            };
            (placed, outer)
        })
    }

    /// The plane faces that the face of this index meets in outer edges.
    pub(super) fn neighbours(&self, index: u32) -> impl Iterator<Item = Self> {
        let faces = self.boundary.flat_neighbours(index).into_iter();
        faces.map(|face| Self::face(self.boundary, self.at, face))
    }

    /// The smallest value of `direction . x` over the piece.
    pub(super) fn lowest(&self, direction: &V) -> Option<f64> {
        match self.surface {
            Surface::Plane { normal, .. } => match &self.corners {
                // The piece may bulge in its plane where its border is round.
                Some(corners) => {
                    let least = corners.iter().map(|c| c.dot(direction));
                    let bulge = self.bulge() * normal.cross(direction).norm();
                    Some(least.fold(f64::INFINITY, f64::min) - bulge)
                }
                None => self.lowest_of_border(direction),
            },
            Surface::Round {
                origin,
                axis,
                radius,
                slope,
                range,
            } => match &self.corners {
                Some(corners) if slope == 0.0 => {
                    let arc = Arc::of(&origin, &axis, corners)?;
                    let heights = corners.map(|c| (c - origin).dot(&axis) * axis.dot(direction));
                    let along = heights.into_iter().fold(f64::INFINITY, f64::min);
                    let across = radius * arc.lowest(direction);
                    Some(origin.dot(direction) + along + across - self.bulge())
                }
                Some(_) => None,
                None => {
                    let end = |z: f64| {
                        let r = (radius + slope * z).abs();
                        (origin + axis * z).dot(direction) - r * axis.cross(direction).norm()
                    };
                    let [from, to] = range.map(end);
                    Some(from.min(to))
                }
            },
            Surface::Sphere { center, radius } => Some(center.dot(direction) - radius),
            Surface::Torus {
                center,
                axis,
                radius,
                tube,
            } => Some(center.dot(direction) - radius * axis.cross(direction).norm() - tube),
            Surface::Other => None,
        }
    }

    fn lowest_of_border(&self, direction: &V) -> Option<f64> {
        let mut least = f64::INFINITY;
        for border in self.borders() {
            least = least.min(match border {
                Edge::Line(a, b) => a.dot(direction).min(b.dot(direction)),
                Edge::Circle {
                    center,
                    axis,
                    radius,
                    start,
                    sweep,
                } => {
                    let arc = Arc::swept(&center, &axis, &start, sweep)?;
                    center.dot(direction) + radius * arc.lowest(direction)
                }
                Edge::Unknown => return None,
            });
        }
        least.is_finite().then_some(least)
    }

    /// How far the piece may reach beyond its triangle along its surface.
    fn bulge(&self) -> f64 {
        self.boundary.bulge(self.face)
    }

    /// A lower bound of the distance from a line, given by a point and a unit direction.
    pub(super) fn nearest_to_line(&self, point: &V, along: &V) -> Option<f64> {
        let away = |p: &V| {
            let arm = p - point;
            (arm - along * arm.dot(along)).norm()
        };
        match self.surface {
            Surface::Plane { origin, normal } => {
                if normal.dot(along).abs() <= PARALLEL {
                    return Some(match &self.corners {
                        Some(corners) => self.flat_beside(corners, &normal, point, along),
                        None => (origin - point).dot(&normal).abs(),
                    });
                }
                if normal.cross(along).norm() > PARALLEL {
                    return None;
                }
                // Across the line: where it passes, and how near the border comes to it there.
                let through = point + along * (origin - point).dot(along);
                if self.covers(&through) {
                    return Some(0.0);
                }
                let mut least = f64::INFINITY;
                for border in self.borders() {
                    least = least.min(match border {
                        Edge::Line(a, b) => to_segment(&through, &a, &b),
                        Edge::Circle { center, radius, .. } => (away(&center) - radius).abs(),
                        Edge::Unknown => return None,
                    });
                }
                least.is_finite().then_some(least)
            }
            Surface::Round {
                origin,
                axis,
                radius,
                slope,
                range,
            } => {
                if axis.cross(along).norm() > PARALLEL {
                    return None;
                }
                if slope != 0.0 {
                    let [from, to] = range.map(|z| (radius + slope * z).abs());
                    return (away(&origin) <= super::side::TOUCH_MM).then(|| from.min(to));
                }
                let arc = self.arc(&origin, &axis)?;
                Some(arc.nearest(radius, &across(&(point - origin), &axis)) - self.bulge_of_round())
            }
            Surface::Sphere { center, radius } => Some((away(&center) - radius).max(0.0)),
            Surface::Torus {
                center,
                axis,
                radius,
                tube,
            } => {
                let coaxial =
                    axis.cross(along).norm() <= PARALLEL && away(&center) <= super::side::TOUCH_MM;
                coaxial.then_some(radius - tube)
            }
            Surface::Other => None,
        }
    }

    /// An upper bound of the distance from a line.
    pub(super) fn farthest_from_line(&self, point: &V, along: &V) -> Option<f64> {
        let away = |p: &V| {
            let arm = p - point;
            (arm - along * arm.dot(along)).norm()
        };
        match self.surface {
            // The distance from a line is convex: it is largest on the border.
            Surface::Plane { .. } => {
                let mut most = 0.0_f64;
                for border in self.borders() {
                    most = most.max(match border {
                        Edge::Line(a, b) => away(&a).max(away(&b)),
                        Edge::Circle {
                            center,
                            axis,
                            radius,
                            start,
                            sweep,
                        } => {
                            if axis.cross(along).norm() <= PARALLEL {
                                let arc = Arc::swept(&center, &axis, &start, sweep)?;
                                arc.farthest(radius, &across(&(point - center), &axis))
                            } else {
                                away(&center) + radius
                            }
                        }
                        Edge::Unknown => return None,
                    });
                }
                Some(most)
            }
            Surface::Round {
                origin,
                axis,
                radius,
                slope,
                range,
            } => {
                if slope == 0.0 && axis.cross(along).norm() <= PARALLEL {
                    let arc = self.arc(&origin, &axis)?;
                    let off = across(&(point - origin), &axis);
                    return Some(arc.farthest(radius, &off) + self.bulge_of_round());
                }
                let [from, to] = range.map(|z| away(&(origin + axis * z)) + radius + slope * z);
                Some(from.max(to))
            }
            Surface::Sphere { center, radius } => Some(away(&center) + radius),
            Surface::Torus {
                center,
                axis,
                radius,
                tube,
            } => {
                let coaxial = axis.cross(along).norm() <= PARALLEL;
                Some(away(&center) + radius + tube).filter(|_| coaxial)
            }
            Surface::Other => None,
        }
    }

    /// A lower bound of the distance from a point: that of its whole surface.
    pub(super) fn nearest_to_point(&self, point: &V) -> Option<f64> {
        let polar = |origin: &V, axis: &V| {
            let arm = point - origin;
            let z = arm.dot(axis);
            ((arm - axis * z).norm(), z)
        };
        match self.surface {
            Surface::Plane { origin, normal } => Some((point - origin).dot(&normal).abs()),
            Surface::Round {
                origin,
                axis,
                radius,
                slope,
                ..
            } => {
                let (rho, z) = polar(&origin, &axis);
                Some((rho - radius - slope * z).abs() / libm::sqrt(1.0 + slope * slope))
            }
            Surface::Sphere { center, radius } => Some(((point - center).norm() - radius).abs()),
            Surface::Torus {
                center,
                axis,
                radius,
                tube,
            } => {
                let (rho, z) = polar(&center, &axis);
                Some((libm::hypot(rho - radius, z) - tube).abs())
            }
            Surface::Other => None,
        }
    }

    /// How far round a cylinder the piece goes.
    fn arc(&self, origin: &V, axis: &V) -> Option<Arc> {
        if let Some(corners) = &self.corners {
            return Arc::of(origin, axis, corners);
        }
        let mut all: Option<Arc> = None;
        for border in self.borders() {
            let Edge::Circle {
                center,
                axis: own,
                start,
                sweep,
                ..
            } = border
            else {
                continue;
            };
            let about = own.cross(axis).norm() <= PARALLEL
                && across(&(center - origin), axis).norm() <= super::side::TOUCH_MM;
            if !about {
                return Some(Arc::whole(axis));
            }
            let arc = Arc::swept(&center, &own, &start, sweep)?;
            match &all {
                // The same arc at the other end; anything else is taken as the whole circle.
                Some(known) if !known.same(&arc) => return Some(Arc::whole(axis)),
                _ => all = Some(arc),
            }
        }
        let straight = self
            .borders()
            .all(|b| matches!(b, Edge::Line(..) | Edge::Circle { .. }));
        match all {
            Some(arc) if straight => Some(arc),
            _ => Some(Arc::whole(axis)),
        }
    }

    /// A piece of a cylinder reaches beyond its triangle where its border is no line or circle.
    fn bulge_of_round(&self) -> f64 {
        match self.corners {
            Some(_) => self.bulge(),
            None => 0.0,
        }
    }

    /// The distance of a line that lies along a plane from a piece of it.
    fn flat_beside(&self, corners: &[V; 3], normal: &V, point: &V, along: &V) -> f64 {
        let side = normal.cross(along);
        let reach = corners.map(|c| (c - point).dot(&side));
        let low = reach.into_iter().fold(f64::INFINITY, f64::min) - self.bulge();
        let high = reach.into_iter().fold(f64::NEG_INFINITY, f64::max) + self.bulge();
        let beside = if low > 0.0 {
            low
        } else if high < 0.0 {
            -high
        } else {
            0.0
        };
        let [corner, ..] = corners;
        libm::hypot(beside, (corner - point).dot(normal))
    }

    /// Whether a point of its plane may lie in a plane face: in one of its triangles.
    fn covers(&self, point: &V) -> bool {
        let Surface::Plane { normal, .. } = self.surface else {
            return true;
        };
        let back = self.at.inverse();
        let own = V::from(back.point((*point).into()));
        let up = V::from(back.direction(normal.into()));
        self.boundary
            .triangles_near(&own, COVER_MM)
            .any(|(face, t)| {
                let [a, b, c] = t;
                let left = |p: &V, q: &V| (q - p).cross(&(own - p)).dot(&up) >= 0.0;
                core::ptr::eq(face, self.face) && left(&a, &b) && left(&b, &c) && left(&c, &a)
            })
    }
}

/// The part of a vector across an axis.
pub(super) fn across(v: &V, axis: &V) -> V {
    v - axis * v.dot(axis)
}

fn to_segment(p: &V, a: &V, b: &V) -> f64 {
    let along = b - a;
    let length = along.norm_squared();
    let t = if length > 0.0 {
        ((p - a).dot(&along) / length).clamp(0.0, 1.0)
    } else {
        0.0
    };
    (p - (a + along * t)).norm()
}

/// A surface at another place.
pub(super) fn placed(surface: &SkinSurface, at: &Placement) -> Surface {
    let point = |p: [f64; 3]| V::from(at.point(p));
    let direction = |d: [f64; 3]| V::from(at.direction(d));
    match *surface {
        SkinSurface::Plane { origin, normal } => Surface::Plane {
            origin: point(origin),
            normal: direction(normal),
        },
        SkinSurface::Cylinder {
            origin,
            axis,
            radius,
            range,
        } => Surface::Round {
            origin: point(origin),
            axis: direction(axis),
            radius,
            slope: 0.0,
            range,
        },
        SkinSurface::Cone {
            origin,
            axis,
            radius,
            slope,
            range,
        } => Surface::Round {
            origin: point(origin),
            axis: direction(axis),
            radius,
            slope,
            range,
        },
        SkinSurface::Sphere { center, radius } => Surface::Sphere {
            center: point(center),
            radius,
        },
        SkinSurface::Torus {
            center,
            axis,
            radius,
            tube,
        } => Surface::Torus {
            center: point(center),
            axis: direction(axis),
            radius,
            tube,
        },
        SkinSurface::Other => Surface::Other,
    }
}
