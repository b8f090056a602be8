//! Frames, outlines, profiles and choices of edges.
#![allow(missing_docs, reason = "the macro makes public items of the functions")]

use assemcad_model::frame::Frame as ModelFrame;
use assemcad_model::recipe::{EdgeSelector, Outline as ModelOutline, Segment as ModelSegment};
use starlark::environment::GlobalsBuilder;
use starlark::eval::Evaluator;
use starlark::starlark_module;
use starlark::values::Value;

use super::session::Session;
use super::{items, positive, vector};
use crate::fault::Fault;
use crate::values::{Edges, Frame, Outline, Profile, Segment};

/// Planes by the names that CadQuery gives them: name, z (the normal) and x.
const PLANES: [(&str, [f64; 3], [f64; 3]); 6] = [
    ("XY", [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]),
    ("XZ", [0.0, -1.0, 0.0], [1.0, 0.0, 0.0]),
    ("YX", [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]),
    ("YZ", [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]),
    ("ZX", [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]),
    ("ZY", [-1.0, 0.0, 0.0], [0.0, 0.0, 1.0]),
];

fn origin_or_zero(origin: Option<Value<'_>>) -> Result<[f64; 3], Fault> {
    origin.map_or(Ok([0.0; 3]), |v| vector(v, "origin"))
}

fn make_frame(origin: [f64; 3], z: [f64; 3], x: [f64; 3]) -> anyhow::Result<Frame> {
    match ModelFrame::new(origin, z, x) {
        Ok(frame) => Ok(Frame { frame }),
        Err(e) => Fault::new(e.to_string())
            .hint(
                "state z and an x at a right angle to it, for example z = (0, 1, 0), x = (1, 0, 0)",
            )
            .raise(),
    }
}

fn direction(value: Value<'_>, what: &str) -> Result<[f64; 3], Fault> {
    let v = vector(value, what)?;
    if v == [0.0; 3] {
        Err(Fault::new(format!("{what} has no length")))
    } else {
        Ok(v)
    }
}

#[starlark_module]
pub(super) fn functions(builder: &mut GlobalsBuilder) {
    /// `frame(origin = (0, 0, 0), z = (0, 0, 1), x = (1, 0, 0))`.
    fn frame<'v>(
        origin: Option<Value<'v>>,
        z: Option<Value<'v>>,
        x: Option<Value<'v>>,
    ) -> anyhow::Result<Frame> {
        let z_direction = z.map_or(Ok([0.0, 0.0, 1.0]), |v| vector(v, "z"))?;
        // A default x is no answer to a slanted z: x is stated, never derived.
        let x_direction = x.map_or(Ok([1.0, 0.0, 0.0]), |v| vector(v, "x"))?;
        make_frame(origin_or_zero(origin)?, z_direction, x_direction)
    }

    /// `plane("XZ", origin = (0, 0, 0))`: the frame of a plane; its z is the plane's normal (XZ looks
    /// along -Y, so that x is X and y is Z).
    fn plane<'v>(name: &str, origin: Option<Value<'v>>) -> anyhow::Result<Frame> {
        let Some((_, z, x)) = PLANES.iter().find(|(plane, _, _)| *plane == name) else {
            let names = PLANES.map(|(name, _, _)| name).join(", ");
            return Fault::new(format!("planes are {names}")).raise();
        };
        make_frame(origin_or_zero(origin)?, *z, *x)
    }

    /// `circle(radius, center = (0, 0))`: a closed outline.
    fn circle<'v>(radius: Value<'v>, center: Option<Value<'v>>) -> anyhow::Result<Outline> {
        let center = center.map_or(Ok([0.0; 2]), |v| vector(v, "center"))?;
        let radius = positive(radius, "radius")?;
        Ok(Outline {
            outline: ModelOutline::Circle { center, radius },
        })
    }

    /// `rectangle(width, height, center = (0, 0))`: a closed outline about its centre.
    fn rectangle<'v>(
        width: Value<'v>,
        height: Value<'v>,
        center: Option<Value<'v>>,
    ) -> anyhow::Result<Outline> {
        let [cx, cy] = center.map_or(Ok([0.0; 2]), |v| vector(v, "center"))?;
        let (w, h) = (
            positive(width, "width")? / 2.0,
            positive(height, "height")? / 2.0,
        );
        let corner = |x: f64, y: f64| ModelSegment::Line {
            to: [cx + x, cy + y],
        };
        let segments = vec![corner(w, -h), corner(w, h), corner(-w, h)];
        Ok(Outline {
            outline: ModelOutline::Path {
                start: [cx - w, cy - h],
                segments,
            },
        })
    }

    /// `polygon([(0, 0), (10, 0), (0, 5)])`: a closed outline of straight lines.
    fn polygon<'v>(points: Value<'v>, eval: &mut Evaluator<'v, '_, '_>) -> anyhow::Result<Outline> {
        let Some(points) = items(points).filter(|p| p.len() >= 3) else {
            return Fault::new("a polygon takes a list of three points or more").raise();
        };
        Session::of(eval)?.charge(points.len())?;
        let mut points = points
            .into_iter()
            .map(|p| vector(p, "a point of the polygon"));
        let start = points.next().unwrap_or(Ok([0.0; 2]))?;
        let segments = points
            .map(|to| to.map(|to| ModelSegment::Line { to }))
            .collect::<Result<_, _>>()?;
        Ok(Outline {
            outline: ModelOutline::Path { start, segments },
        })
    }

    /// `line(to)`: a piece of a path.
    fn line<'v>(to: Value<'v>) -> anyhow::Result<Segment> {
        Ok(Segment {
            segment: ModelSegment::Line {
                to: vector(to, "to")?,
            },
        })
    }

    /// `arc(via, to)`: a piece of a path, circular, through `via`.
    fn arc<'v>(via: Value<'v>, to: Value<'v>) -> anyhow::Result<Segment> {
        let (via, to) = (vector(via, "via")?, vector(to, "to")?);
        Ok(Segment {
            segment: ModelSegment::Arc { via, to },
        })
    }

    /// `path(start, [line(to), arc(via, to), ...])`: a closed outline; a line joins its end to its
    /// start where they differ.
    fn path<'v>(
        start: Value<'v>,
        segments: Value<'v>,
        eval: &mut Evaluator<'v, '_, '_>,
    ) -> anyhow::Result<Outline> {
        let segments = items(segments).and_then(|list| {
            list.into_iter()
                .map(|v| Segment::from_value(v).map(|s| s.segment.clone()))
                .collect::<Option<Vec<_>>>()
        });
        let Some(segments) = segments.filter(|s| !s.is_empty()) else {
            return Fault::new("a path takes its start and a list of line(...) and arc(...)")
                .raise();
        };
        Session::of(eval)?.charge(segments.len())?;
        Ok(Outline {
            outline: ModelOutline::Path {
                start: vector(start, "start")?,
                segments,
            },
        })
    }

    /// `profile(outer, holes = [], at = frame())`: a plane region in the x-y plane of `at`.
    fn profile<'v>(
        outer: &'v Outline,
        holes: Option<Value<'v>>,
        at: Option<&'v Frame>,
        eval: &mut Evaluator<'v, '_, '_>,
    ) -> anyhow::Result<Profile> {
        let holes = match holes {
            None => Some(Vec::new()),
            Some(holes) => items(holes).and_then(|list| {
                list.into_iter()
                    .map(|v| Outline::from_value(v).map(|o| o.outline.clone()))
                    .collect()
            }),
        };
        let Some(holes) = holes else {
            return Fault::new("holes is a list of outlines").raise();
        };
        let profile = assemcad_model::recipe::Profile {
            at: at.map_or(ModelFrame::WORLD, |at| at.frame),
            outer: outer.outline.clone(),
            holes,
        };
        Session::of(eval)?.charge(crate::values::pieces(&profile))?;
        Ok(Profile { profile })
    }

    /// `all_edges()`: every edge of a solid.
    fn all_edges() -> anyhow::Result<Edges> {
        Ok(Edges {
            edges: EdgeSelector::All,
        })
    }

    /// `edges_parallel(direction)`: the straight edges along a direction, either way.
    fn edges_parallel<'v>(along: Value<'v>) -> anyhow::Result<Edges> {
        Ok(Edges {
            edges: EdgeSelector::Parallel {
                direction: direction(along, "direction")?,
            },
        })
    }

    /// `edges_in_plane(point, normal)`: the edges that lie wholly in a plane.
    fn edges_in_plane<'v>(point: Value<'v>, normal: Value<'v>) -> anyhow::Result<Edges> {
        let (point, normal) = (vector(point, "point")?, direction(normal, "normal")?);
        Ok(Edges {
            edges: EdgeSelector::InPlane { point, normal },
        })
    }
}
