//! Whether a piece of a face lies on the outer side of a surface.

use super::patch::{PARALLEL, Patch, Surface, V, across};

/// Up to this depth a piece may be below a surface and still count as on it, in mm: what placing and the
/// kernel's own tolerance leave.
pub(super) const TOUCH_MM: f64 = 2e-7;

/// Whether all of a piece is for sure on the outer side of the surface of another, or on it.
pub(super) fn outside(of: &Patch<'_>, piece: &Patch<'_>) -> bool {
    let above = |bound: Option<f64>, least: f64| bound.is_some_and(|b| b >= least - TOUCH_MM);
    let below = |bound: Option<f64>, most: f64| bound.is_some_and(|b| b <= most + TOUCH_MM);
    match of.surface {
        Surface::Plane { origin, normal } => above(piece.lowest(&normal), origin.dot(&normal)),
        Surface::Round {
            origin,
            axis,
            radius,
            slope: 0.0,
            ..
        } => match of.hollow() {
            true => below(piece.farthest_from_line(&origin, &axis), radius),
            false => above(piece.nearest_to_line(&origin, &axis), radius),
        },
        Surface::Round {
            origin,
            axis,
            radius,
            slope,
            ..
        } => beside_cone(
            &Cone {
                origin,
                axis,
                radius,
                slope,
            },
            of.hollow(),
            piece,
        ),
        Surface::Sphere { center, radius } => match of.hollow() {
            // Only balls are held against sockets: what else is in one is held against its own surface.
            true => match piece.surface {
                Surface::Sphere {
                    center: own,
                    radius: r,
                } => (own - center).norm() + r <= radius + TOUCH_MM,
                _ => false,
            },
            false => above(piece.nearest_to_point(&center), radius),
        },
        Surface::Torus {
            center,
            axis,
            radius,
            tube,
        } => !of.hollow() && beside_ring(&center, &axis, radius, tube, piece),
        Surface::Other => false,
    }
}

struct Cone {
    origin: V,
    axis: V,
    radius: f64,
    slope: f64,
}

/// Beside a cone: pieces that are round about its axis, planes across it, and balls on it.
fn beside_cone(cone: &Cone, hollow: bool, piece: &Patch<'_>) -> bool {
    let polar = |p: &V| {
        let arm = p - cone.origin;
        (arm.dot(&cone.axis), across(&arm, &cone.axis).norm())
    };
    // Above 0 outside of the cone, along its normal.
    let scale = 1.0 / libm::sqrt(1.0 + cone.slope * cone.slope);
    let over = |z: f64, rho: f64| (rho - cone.radius - cone.slope * z) * scale;
    let (low, high) = match piece.surface {
        Surface::Round {
            origin,
            axis,
            radius,
            slope,
            range,
        } => {
            let (_, off) = polar(&origin);
            if axis.cross(&cone.axis).norm() > PARALLEL || off > TOUCH_MM {
                return false;
            }
            let [a, b] =
                range.map(|z| over(polar(&(origin + axis * z)).0, (radius + slope * z).abs()));
            (a.min(b), a.max(b))
        }
        Surface::Plane { origin, normal } => {
            if normal.cross(&cone.axis).norm() > PARALLEL {
                return false;
            }
            let (z, _) = polar(&origin);
            let (Some(near), Some(far)) = (
                piece.nearest_to_line(&cone.origin, &cone.axis),
                piece.farthest_from_line(&cone.origin, &cone.axis),
            ) else {
                return false;
            };
            (over(z, near), over(z, far))
        }
        Surface::Sphere { center, radius } => {
            let (z, off) = polar(&center);
            if off > TOUCH_MM {
                return false;
            }
            (over(z, 0.0) - radius, over(z, 0.0) + radius)
        }
        Surface::Torus { .. } | Surface::Other => return false,
    };
    match hollow {
        true => high <= TOUCH_MM,
        false => low >= -TOUCH_MM,
    }
}

/// Beside a ring of round section: what has the same axis, or a plane across it.
fn beside_ring(center: &V, axis: &V, radius: f64, tube: f64, piece: &Patch<'_>) -> bool {
    let coaxial = |origin: &V, own: &V| {
        own.cross(axis).norm() <= PARALLEL && across(&(origin - center), axis).norm() <= TOUCH_MM
    };
    let gap = match piece.surface {
        Surface::Plane { origin, normal } if normal.cross(axis).norm() <= PARALLEL => {
            (origin - center).dot(axis).abs()
        }
        Surface::Round {
            origin,
            axis: own,
            radius: r,
            slope,
            ..
        } if coaxial(&origin, &own) => {
            let sign = own.dot(axis);
            let z = (center - origin).dot(axis) * sign;
            (radius - r - slope * z).abs() / libm::sqrt(1.0 + slope * slope)
        }
        Surface::Torus {
            center: other,
            axis: own,
            radius: r,
            tube: t,
        } if coaxial(&other, &own) => {
            (libm::hypot(radius - r, (other - center).dot(axis)) - t).abs()
        }
        Surface::Sphere {
            center: ball,
            radius: r,
        } if across(&(ball - center), axis).norm() <= TOUCH_MM => {
            (libm::hypot(radius, (ball - center).dot(axis)) - r).abs()
        }
        _ => return false,
    };
    gap >= tube - TOUCH_MM
}
