//! Answers to the probes of ports: what a solid has at stated places.

use core::f64::consts::PI;

use assemcad_model::probe::{
    Answer, COINCIDENCE_MM, DIRECTION_RAD, LEAST_AREA, Probe, Test, gap_allowed_mm,
};
use nalgebra::Vector3;

use crate::error::{KernelError, Result};
use crate::facts::{Face, Surface};
use crate::query::Side;
use crate::shape::Shape;

/// How near to the surface a point is on it rather than on one side, in mm.
const ON_MM: f64 = 1e-6;

impl Shape {
    /// Answers every probe, in order.
    ///
    /// # Errors
    /// When a number is out of range or the kernel cannot tell.
    pub fn probe(&self, probes: &[Probe]) -> Result<Vec<Answer>> {
        let solid = Asked {
            shape: self,
            faces: self.faces()?,
        };
        // The many points together: a classifier is dear to set up.
        let points: Vec<[f64; 3]> = probes.iter().filter_map(|p| point(&p.test)).collect();
        let mut sides = self.classify(&points, ON_MM)?.into_iter();
        probes
            .iter()
            .map(|p| match point(&p.test) {
                Some(at) => {
                    let side = sides
                        .next()
                        .ok_or_else(|| KernelError::internal("a point was not classified"))?;
                    Ok(sided(&p.test, at, side))
                }
                None => solid.answer(&p.test),
            })
            .collect()
    }
}

/// The point of a test that asks on which side it is.
fn point(test: &Test) -> Option<[f64; 3]> {
    match test {
        Test::In { point } | Test::Out { point } => Some(*point),
        _ => None,
    }
}

fn sided(test: &Test, at: [f64; 3], side: Side) -> Answer {
    let wanted = match test {
        Test::In { .. } => Side::Inside,
        _ => Side::Outside,
    };
    let found = match side {
        Side::Inside => "the point lies in the material",
        Side::Outside => "the point lies outside of the material",
        Side::Boundary => "the point lies on the surface",
    };
    Answer {
        held: side == wanted,
        at,
        found: found.to_owned(),
    }
}

struct Asked<'a> {
    shape: &'a Shape,
    faces: Vec<Face>,
}

impl Asked<'_> {
    fn answer(&self, test: &Test) -> Result<Answer> {
        match test {
            Test::In { point } | Test::Out { point } => {
                Ok(sided(test, *point, self.side(*point, ON_MM)?))
            }
            Test::Plane { point, normal } => self.plane(*point, *normal),
            Test::Cylinder {
                point,
                axis,
                radius,
                length,
                inward,
            } => {
                let window = Window {
                    point: (*point).into(),
                    axis: (*axis).into(),
                    radius: *radius,
                    length: *length,
                    inward: *inward,
                };
                Ok(self.cylinder(&window))
            }
            Test::AnyOf { of } => {
                let mut first = None;
                for test in of {
                    let answer = self.answer(test)?;
                    if answer.held {
                        return Ok(answer);
                    }
                    first = first.or(Some(answer));
                }
                let mut answer =
                    first.ok_or_else(|| KernelError::refused("a probe asks for any of nothing"))?;
                answer.found = format!(
                    "at none of {} places is it so; at the first, {}",
                    of.len(),
                    answer.found
                );
                Ok(answer)
            }
        }
    }

    fn side(&self, point: [f64; 3], tolerance: f64) -> Result<Side> {
        let sides = self.shape.classify(&[point], tolerance)?;
        sides
            .first()
            .copied()
            .ok_or_else(|| KernelError::internal("a point was not classified"))
    }

    fn plane(&self, at: [f64; 3], normal: [f64; 3]) -> Result<Answer> {
        let (point, wanted) = (Vector3::from(at), Vector3::from(normal));
        let mut nearest = f64::INFINITY;
        let mut turned = false;
        let mut there = false;
        for face in &self.faces {
            let Surface::Plane { normal } = face.surface else {
                continue;
            };
            let normal = Vector3::from(normal);
            let off = (point - Vector3::from(face.origin)).dot(&normal).abs();
            let beside = beside(face, at);
            if angle(&normal, &wanted) <= DIRECTION_RAD {
                if beside <= COINCIDENCE_MM {
                    nearest = nearest.min(off);
                    there |= off <= COINCIDENCE_MM;
                }
            } else if angle(&-normal, &wanted) <= DIRECTION_RAD {
                turned |= off <= COINCIDENCE_MM && beside <= COINCIDENCE_MM;
            }
        }
        let on = self.side(at, COINCIDENCE_MM)? == Side::Boundary;
        let found = if there && on {
            "a plane face is there".to_owned()
        } else if there {
            "the plane of a face passes there, but the face itself does not reach the point"
                .to_owned()
        } else if turned {
            "the face there looks the other way".to_owned()
        } else if nearest.is_finite() {
            format!("the nearest plane face with this normal is {nearest:.4} mm off")
        } else {
            "no plane face with this normal is there".to_owned()
        };
        Ok(Answer {
            held: there && on,
            at,
            found,
        })
    }

    fn cylinder(&self, window: &Window) -> Answer {
        let (mut pieces, mut area) = (Vec::new(), 0.0);
        let mut others = Vec::new();
        for face in &self.faces {
            let Some((low, high, radius, inward)) = window.coaxial(face) else {
                continue;
            };
            let (from, to) = (low.max(0.0), high.min(window.length));
            if from >= to {
                continue;
            }
            if (radius - window.radius).abs() > COINCIDENCE_MM {
                others.push(format!("one of diameter {:.4} mm", 2.0 * radius));
            } else if inward != window.inward {
                others.push(if inward {
                    "the wall of a hole".to_owned()
                } else {
                    "the outer surface of a solid".to_owned()
                });
            } else {
                pieces.push((from, to));
                area += face.area * (to - from) / (high - low);
            }
        }
        let covered = covered(pieces);
        let least = window.length - gap_allowed_mm(window.length);
        let whole = 2.0 * PI * window.radius * covered;
        let found = if covered <= 0.0 && others.is_empty() {
            "no cylinder face is about this axis".to_owned()
        } else if covered <= 0.0 {
            others.dedup();
            format!("the cylinder about this axis is {}", others.join(", "))
        } else {
            format!(
                "such a cylinder face covers {covered:.4} of {:.4} mm, {:.0} percent of it around",
                window.length,
                100.0 * area / whole
            )
        };
        // The slack takes up rounding.
        let long = covered >= least - COINCIDENCE_MM && covered > 0.0;
        Answer {
            held: long && area >= LEAST_AREA * whole,
            at: window.point.into(),
            found,
        }
    }
}

/// A cylinder that should be there.
struct Window {
    point: Vector3<f64>,
    axis: Vector3<f64>,
    radius: f64,
    length: f64,
    inward: bool,
}

impl Window {
    /// Where a cylinder face about this axis begins and ends along it, its radius, and whether it is
    /// the wall of a hole.
    fn coaxial(&self, face: &Face) -> Option<(f64, f64, f64, bool)> {
        let Surface::Cylinder {
            axis,
            radius,
            inward,
            range: [low, high],
            ..
        } = face.surface
        else {
            return None;
        };
        let (origin, axis) = (Vector3::from(face.origin), Vector3::from(axis));
        let sign = axis.dot(&self.axis).signum();
        if angle(&(axis * sign), &self.axis) > DIRECTION_RAD {
            return None;
        }
        // Both ends of the window lie on the face's axis.
        for end in [self.point, self.point + self.axis * self.length] {
            let arm = end - origin;
            if (arm - axis * arm.dot(&axis)).norm() > COINCIDENCE_MM {
                return None;
            }
        }
        let along = |t: f64| (origin + axis * t - self.point).dot(&self.axis);
        let (a, b) = (along(low), along(high));
        Some((a.min(b), a.max(b), radius, inward))
    }
}

/// The length of the union of intervals.
fn covered(mut pieces: Vec<(f64, f64)>) -> f64 {
    pieces.sort_by(|a, b| a.0.total_cmp(&b.0));
    let (mut sum, mut end) = (0.0, f64::NEG_INFINITY);
    for (from, to) in pieces {
        sum += (to - from.max(end)).max(0.0);
        end = end.max(to);
    }
    sum
}

/// How far a point is outside of a face's box, in mm.
fn beside(face: &Face, at: [f64; 3]) -> f64 {
    // Along the normal the box is as thin as the face: the distance there is judged on its own.
    let Surface::Plane { normal } = face.surface else {
        return f64::INFINITY;
    };
    let normal = Vector3::from(normal);
    let point = Vector3::from(at);
    let foot = point - normal * (point - Vector3::from(face.origin)).dot(&normal);
    let low = Vector3::from(face.bounds.min) - foot;
    let high = foot - Vector3::from(face.bounds.max);
    low.max().max(high.max())
}

/// The angle between two unit vectors, in radians.
fn angle(a: &Vector3<f64>, b: &Vector3<f64>) -> f64 {
    libm::atan2(a.cross(b).norm(), a.dot(b))
}
