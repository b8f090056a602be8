//! Shapes made directly, and what is done to them.

use assemcad_model::frame::Placement;

use super::args::Args;
use super::chain::plane;
use super::each::kernel_x;
use super::transform::{body, mirror_plane, moved_object, rotation, translation};
use super::value::{Object, Value};
use crate::error::{KernelError, Result};
use crate::shape::Shape;

/// A point and a direction: x as the kernel derives it.
fn upright(args: &Args<'_>, point: &str, direction: &str) -> Result<Placement> {
    let z = args.vector(direction)?;
    if z.norm() == 0.0 {
        return Err(KernelError::refused("the direction has no length"));
    }
    plane(args.vector(point)?, kernel_x(&z.normalize()), z)
}

fn frame(at: &Placement) -> assemcad_model::frame::Frame {
    at.frame(&assemcad_model::frame::Frame::WORLD)
}

/// The functions of `cq` that make a shape.
pub(super) fn make(args: &Args<'_>) -> Result<Value> {
    let made = match args.call.call.as_str() {
        "Solid.makeBox" => {
            let size = [
                args.length("length")?,
                args.length("width")?,
                args.length("height")?,
            ];
            Shape::cuboid(&frame(&upright(args, "pnt", "dir")?), size)?
        }
        "Solid.makeCylinder" => Shape::cylinder_part(
            &upright(args, "pnt", "dir")?,
            args.length("radius")?,
            args.length("height")?,
            args.real("angleDegrees")?,
        )?,
        "Solid.makeCone" => Shape::cone_part(
            &upright(args, "pnt", "dir")?,
            args.real("radius1")?,
            args.real("radius2")?,
            args.length("height")?,
            args.real("angleDegrees")?,
        )?,
        "Solid.makeSphere" => Shape::sphere_part(
            &upright(args, "pnt", "dir")?,
            args.length("radius")?,
            args.real("angleDegrees1")?,
            args.real("angleDegrees2")?,
            args.real("angleDegrees3")?,
        )?,
        "Solid.makeTorus" => Shape::torus(
            &upright(args, "pnt", "dir")?,
            args.length("radius1")?,
            args.length("radius2")?,
        )?,
        "Edge.makeLine" => Shape::line_edge(args.vector("v1")?.into(), args.vector("v2")?.into())?,
        "Edge.makeThreePointArc" => Shape::arc_edge(
            args.vector("v1")?.into(),
            args.vector("v2")?.into(),
            args.vector("v3")?.into(),
        )?,
        "Edge.makeCircle" => {
            let at = upright(args, "pnt", "dir")?;
            let (radius, from, to) = (
                args.length("radius")?,
                args.real("angle1")?,
                args.real("angle2")?,
            );
            if from == to {
                Shape::circle_edge(&at, radius)?
            } else {
                Shape::circle_arc_edge(&at, radius, from, to)?
            }
        }
        "Edge.makeSpline" => {
            let points: Vec<[f64; 3]> = args
                .vectors("listOfVector")?
                .into_iter()
                .map(Into::into)
                .collect();
            Shape::spline_edge(&crate::brep::Spline {
                points: &points,
                tangents: None,
                periodic: false,
                parameters: None,
                scale: true,
                tolerance: 1e-6,
            })?
        }
        "Wire.makePolygon" => {
            let points: Vec<[f64; 3]> = args
                .vectors("listOfVertices")?
                .into_iter()
                .map(Into::into)
                .collect();
            Shape::polyline_wire(&points, args.flag("close")?)?
        }
        "Wire.makeCircle" => {
            let at = upright(args, "center", "normal")?;
            Shape::wire(&[&Shape::circle_edge(&at, args.length("radius")?)?])?
        }
        "Wire.makeHelix" => Shape::helix_wire(
            args.length("pitch")?,
            args.length("height")?,
            args.length("radius")?,
            &upright(args, "center", "dir")?,
            args.real("angle")?,
            args.flag("lefthand")?,
        )?,
        "Wire.assembleEdges" => {
            let objects = args.objects("listOfEdges")?;
            let edges = objects.iter().map(body).collect::<Result<Vec<_>>>()?;
            Shape::wire(&edges)?
        }
        "Compound.makeCompound" => {
            let objects = args.objects("listOfShapes")?;
            let shapes = objects.iter().map(body).collect::<Result<Vec<_>>>()?;
            Shape::compound(&shapes)?
        }
        other => return Err(unknown(other)),
    };
    Ok(Value::Object(Object::shape(made)))
}

pub(super) fn unknown(call: &str) -> KernelError {
    KernelError::refused(format!(
        "there is no call '{}' in this language",
        assemcad_model::param::clip(call)
    ))
}

/// The methods of a shape.
pub(super) fn method(args: &Args<'_>, short: &str) -> Result<Value> {
    let object = args.on_object()?;
    let moved = match short {
        // A shape has no place of its own here: what was made is where it was made.
        "moved" | "located" => moved_object(&object, &args.place("loc")?)?,
        "translate" => moved_object(&object, &translation(args.vector("vector")?))?,
        "rotate" => moved_object(
            &object,
            &rotation(
                args.vector("startVector")?,
                args.vector("endVector")?,
                args.real("angleDegrees")?,
            )?,
        )?,
        "mirror" => {
            let (on_face, normal) = mirror_plane(args)?;
            let point = on_face.unwrap_or(args.vector("basePointVector")?);
            Object::shape(body(&object)?.mirrored(point.into(), normal.into())?)
        }
        "clean" => Object::shape(body(&object)?.cleaned()?),
        "fuse" => {
            let others = args.objects("toFuse")?;
            let others = others.iter().map(body).collect::<Result<Vec<_>>>()?;
            let tolerance = args.real_or_none("tol")?;
            Object::shape(body(&object)?.fused(&others, args.flag("glue")?, tolerance)?)
        }
        "cut" => {
            let others = args.objects("toCut")?;
            let others = others.iter().map(body).collect::<Result<Vec<_>>>()?;
            Object::shape(body(&object)?.without(&others, args.real_or_none("tol")?)?)
        }
        "intersect" => {
            let others = args.objects("toIntersect")?;
            let others = others.iter().map(body).collect::<Result<Vec<_>>>()?;
            Object::shape(body(&object)?.shared(&others, args.real_or_none("tol")?)?)
        }
        _ => return Err(unknown(&args.call.call)),
    };
    Ok(Value::Object(moved))
}
