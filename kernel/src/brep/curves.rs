//! Edges from points and numbers.

use assemcad_model::frame::Placement;
use nalgebra::Vector3;

use super::ffi::bridge;
use super::{apart, frame, made, radians, run};
use crate::error::{KernelError, Result};
use crate::limits::{coordinates, direction, length};
use crate::shape::{Shape, start};

/// A curve through points.
#[derive(Debug, Clone, Copy)]
pub struct Spline<'a> {
    /// The points in mm, at least two, at least three where periodic; a periodic one does not repeat
    /// its first point.
    pub points: &'a [[f64; 3]],
    /// Directions that the curve shall have: two for its ends, or one for each point, where `None`
    /// leaves it free.
    pub tangents: Option<&'a [Option<[f64; 3]>]>,
    /// Whether the curve runs smoothly back to its start.
    pub periodic: bool,
    /// Increasing parameters of the points; a periodic curve has one more, for its return.
    pub parameters: Option<&'a [f64]>,
    /// Whether the lengths of the tangents are set by the kernel rather than taken as they are.
    pub scale: bool,
    /// Points nearer to each other than this, in mm, are refused.
    pub tolerance: f64,
}

/// The highest degree of curves in the kernel.
const HIGHEST_DEGREE: u32 = 25;

impl Shape {
    /// A straight edge.
    ///
    /// # Errors
    /// When its ends are in one place or a number is out of range.
    pub fn line_edge(a: [f64; 3], b: [f64; 3]) -> Result<Self> {
        start()?;
        run("line", &[a, b])?;
        made(bridge::edge_line(&a, &b), || {
            "the line could not be built".into()
        })
    }

    /// An arc of a circle from `a` over `via` to `b`.
    ///
    /// # Errors
    /// When the points lie on a line or a number is out of range.
    pub fn arc_edge(a: [f64; 3], via: [f64; 3], b: [f64; 3]) -> Result<Self> {
        start()?;
        run("arc", &[a, via, b])?;
        apart("arc", &a, &b)?;
        made(bridge::edge_arc(&a, &via, &b), || {
            "the arc could not be built".into()
        })
    }

    /// An arc of a circle that leaves `a` along `tangent` and ends in `b`.
    ///
    /// # Errors
    /// When the end lies straight ahead or a number is out of range.
    pub fn tangent_arc_edge(a: [f64; 3], tangent: [f64; 3], b: [f64; 3]) -> Result<Self> {
        start()?;
        run("arc", &[a, b])?;
        direction("tangent of the arc", &tangent)?;
        if straight(&tangent, &a, &b) {
            return Err(KernelError::refused(
                "the arc could not be built: its end lies straight ahead of its start",
            ));
        }
        made(bridge::edge_tangent_arc(&a, &tangent, &b), || {
            "the arc could not be built".into()
        })
    }

    /// A circle about the origin of `at` in its xy plane, from its x axis round.
    ///
    /// # Errors
    /// When the radius is no length the kernel takes.
    pub fn circle_edge(at: &Placement, radius: f64) -> Result<Self> {
        length("circle's radius", radius)?;
        made(bridge::edge_circle(&frame(at)?, radius), || {
            "the circle could not be built".into()
        })
    }

    /// An arc of the circle of [`Shape::circle_edge`] between two angles from the x axis; the full
    /// circle where they are equal.
    ///
    /// # Errors
    /// When a number is out of range.
    pub fn circle_arc_edge(
        at: &Placement,
        radius: f64,
        from_deg: f64,
        to_deg: f64,
    ) -> Result<Self> {
        let (from, to) = (
            radians("arc's first angle", from_deg)?,
            radians("arc's second angle", to_deg)?,
        );
        if from_deg == to_deg {
            return Self::circle_edge(at, radius);
        }
        length("arc's radius", radius)?;
        made(
            bridge::edge_circle_arc(&frame(at)?, radius, from, to),
            || "the arc could not be built".into(),
        )
    }

    /// An ellipse about the origin of `at` in its xy plane, turned about z by `rotation_deg`; either
    /// radius may be the larger one.
    ///
    /// # Errors
    /// When a number is out of range.
    pub fn ellipse_edge(
        at: &Placement,
        x_radius: f64,
        y_radius: f64,
        rotation_deg: f64,
    ) -> Result<Self> {
        radii(x_radius, y_radius)?;
        let turn = radians("ellipse's rotation", rotation_deg)?;
        made(
            bridge::edge_ellipse(&frame(at)?, x_radius, y_radius, turn),
            || "the ellipse could not be built".into(),
        )
    }

    /// An arc of an ellipse between two angles of its parameter from the x axis; the full ellipse
    /// where they are equal. `forward` runs about z from the first to the second angle, else back.
    ///
    /// # Errors
    /// When a number is out of range.
    pub fn ellipse_arc_edge(
        at: &Placement,
        x_radius: f64,
        y_radius: f64,
        from_deg: f64,
        to_deg: f64,
        forward: bool,
    ) -> Result<Self> {
        let (from, to) = (
            radians("arc's first angle", from_deg)?,
            radians("arc's second angle", to_deg)?,
        );
        if from_deg == to_deg {
            return Self::ellipse_edge(at, x_radius, y_radius, 0.0);
        }
        radii(x_radius, y_radius)?;
        made(
            bridge::edge_ellipse_arc(&frame(at)?, x_radius, y_radius, from, to, forward),
            || "the arc of an ellipse could not be built".into(),
        )
    }

    /// A B-spline through points.
    ///
    /// # Errors
    /// When points that follow each other coincide, tangents or parameters do not fit the points, or a
    /// number is out of range.
    pub fn spline_edge(s: &Spline<'_>) -> Result<Self> {
        start()?;
        let flat = run("spline", s.points)?;
        length("spline's tolerance", s.tolerance)?;
        let count = s.points.len();
        if s.periodic {
            if count < 3 {
                return Err(KernelError::refused(
                    "a spline that runs back to its start needs at least 3 points",
                ));
            }
            if let (Some(first), Some(last)) = (s.points.first(), s.points.last()) {
                apart("spline", last, first)?;
            }
        }
        let parameters = s.parameters.unwrap_or_default();
        if s.parameters.is_some() {
            parameters_fit(parameters, count + usize::from(s.periodic))?;
        }
        let (given, tangents) = tangents(s.tangents.unwrap_or_default(), count)?;
        made(
            bridge::edge_spline(
                flat,
                &tangents,
                &given,
                parameters,
                s.periodic,
                s.scale,
                s.tolerance,
            ),
            || "the spline could not be built".into(),
        )
    }

    /// A B-spline that comes within `tolerance` mm of points.
    ///
    /// # Errors
    /// When points that follow each other coincide, or a number is out of range.
    pub fn spline_approx_edge(
        points: &[[f64; 3]],
        tolerance: f64,
        min_degree: u32,
        max_degree: u32,
    ) -> Result<Self> {
        start()?;
        let flat = run("spline", points)?;
        length("spline's tolerance", tolerance)?;
        if !(1 <= min_degree && min_degree <= max_degree && max_degree <= HIGHEST_DEGREE) {
            return Err(KernelError::refused(format!(
                "the spline's degrees are {min_degree} to {max_degree}, and must lie between 1 and \
                 {HIGHEST_DEGREE}"
            )));
        }
        made(
            bridge::edge_spline_approx(flat, tolerance, min_degree, max_degree),
            || "the spline could not be built".into(),
        )
    }

    /// A Bezier curve with these poles, 2 to 26 of them.
    ///
    /// # Errors
    /// When there are too few or too many, or a number is out of range.
    pub fn bezier_edge(points: &[[f64; 3]]) -> Result<Self> {
        start()?;
        let flat = points.as_flattened();
        coordinates("Bezier curve", flat)?;
        // Poles may coincide, but not all of them.
        let Some(first) = points.first() else {
            return Err(KernelError::refused("the Bezier curve has no points"));
        };
        if points.iter().all(|p| apart("", first, p).is_err()) {
            return Err(KernelError::refused(
                "the Bezier curve has all its points in one place",
            ));
        }
        made(bridge::edge_bezier(flat), || {
            "the Bezier curve could not be built".into()
        })
    }
}

/// Whether the sine of the angle between the tangent and the way to the end is as good as 0: the kernel
/// makes something of that too.
fn straight(tangent: &[f64; 3], a: &[f64; 3], b: &[f64; 3]) -> bool {
    let (t, a, b) = (
        Vector3::from(*tangent),
        Vector3::from(*a),
        Vector3::from(*b),
    );
    let chord = b - a;
    t.cross(&chord).norm() <= 1e-9 * t.norm() * chord.norm()
}

fn radii(x_radius: f64, y_radius: f64) -> Result<()> {
    length("ellipse's x radius", x_radius)?;
    length("ellipse's y radius", y_radius)
}

fn parameters_fit(parameters: &[f64], needed: usize) -> Result<()> {
    if parameters.len() != needed {
        return Err(KernelError::refused(format!(
            "the spline has {} parameters, and needs {needed}",
            parameters.len()
        )));
    }
    coordinates("spline's parameters", parameters)?;
    let rising = |(a, b): (&f64, &f64)| b - a > 1e-9;
    if parameters.iter().zip(parameters.iter().skip(1)).all(rising) {
        Ok(())
    } else {
        Err(KernelError::refused(
            "the parameters of the spline do not increase",
        ))
    }
}

/// Which points have a tangent, and the tangents with zeros where none is.
fn tangents(given: &[Option<[f64; 3]>], points: usize) -> Result<(Vec<bool>, Vec<f64>)> {
    if given.is_empty() {
        return Ok((Vec::new(), Vec::new()));
    }
    let ends = given.len() == 2;
    if given.len() != points && !ends {
        return Err(KernelError::refused(format!(
            "the spline has {} tangents, and takes 2, for its ends, or {points}, one for each point",
            given.len()
        )));
    }
    for tangent in given.iter().flatten() {
        direction("tangent of the spline", tangent)?;
        coordinates("tangent of the spline", tangent)?;
    }
    if ends && points != 2 && given.iter().any(Option::is_none) {
        return Err(KernelError::refused(
            "the spline takes tangents at both of its ends, or one entry for each point",
        ));
    }
    let flags = given.iter().map(Option::is_some).collect();
    let flat = given.iter().flat_map(|t| t.unwrap_or_default()).collect();
    Ok((flags, flat))
}
