//! What is done to the chain's solid: rounded, bevelled, hollowed, split, sectioned.

use std::rc::Rc;

use assemcad_model::frame::{Frame, Placement};

use super::args::Args;
use super::combine::cut;
use super::draw::corner;
use super::solid::{finish, sound, through};
use super::value::{Node, Object, Value};
use crate::brep::Topology;
use crate::error::{KernelError, Result};
use crate::shape::Shape;

/// The edges of what is selected.
fn edges(node: &Node, what: &str) -> Result<Vec<Rc<Shape>>> {
    let edges = super::chain::parts(node, Topology::Edge)?;
    if edges.is_empty() {
        return Err(KernelError::refused(format!(
            "a {what} needs edges, and none are selected"
        )));
    }
    Ok(edges)
}

/// `fillet(radius)`.
pub(super) fn fillet(args: &Args<'_>) -> Result<Value> {
    let node = args.on()?;
    let (solid, edges) = (node.solid()?, edges(&node, "fillet")?);
    let all: Vec<&Shape> = edges.iter().map(Rc::as_ref).collect();
    let radius = args.length("radius")?;
    let made = solid
        .filleted(&all, radius)
        .and_then(|made| sound(made, &format!("the fillet of {radius} mm")))
        .map_err(|e| tight(e, &solid, &all, radius))?;
    finish(&node, made, true)
}

/// `chamfer(length, length2)`.
pub(super) fn chamfer(args: &Args<'_>) -> Result<Value> {
    let node = args.on()?;
    let (solid, edges) = (node.solid()?, edges(&node, "chamfer")?);
    let all: Vec<&Shape> = edges.iter().map(Rc::as_ref).collect();
    let length = args.length("length")?;
    let made = solid
        .chamfered(&all, length, args.real_or_none("length2")?)
        .and_then(|made| sound(made, &format!("the chamfer of {length} mm")))
        .map_err(|e| tight(e, &solid, &all, length))?;
    finish(&node, made, false)
}

/// Says what is small beside the size that was asked for.
fn tight(error: KernelError, solid: &Shape, edges: &[&Shape], size: f64) -> KernelError {
    let narrow = || -> Result<f64> {
        let mut least = f64::INFINITY;
        for edge in edges {
            least = least.min(edge.measure()?.length);
            for face in solid.ancestors(edge, Topology::Face)? {
                let mut extent = face.extent()?.size();
                extent.sort_by(f64::total_cmp);
                // The smallest extent of a plane face is its thickness, 0: the middle one counts.
                let [_, middle, _] = extent;
                least = least.min(middle);
            }
        }
        Ok(least)
    };
    match narrow() {
        Ok(least) if least.is_finite() && least <= 2.0 * size => KernelError {
            message: format!(
                "{}; {size} mm is asked for where a selected edge or the face beside it measures \
                 only {least:.3} mm",
                error.message
            ),
            ..error
        },
        _ => error,
    }
}

/// `shell(thickness, kind)`.
pub(super) fn shell(args: &Args<'_>) -> Result<Value> {
    let node = args.on()?;
    let solid = node.solid()?;
    let mut open = Vec::new();
    for object in &node.objects {
        if let Some(face) = object.of(Topology::Face)? {
            open.push(Rc::clone(face));
        }
    }
    let open: Vec<&Shape> = open.iter().map(Rc::as_ref).collect();
    let thickness = args.real("thickness")?;
    let made = solid.hollowed(&open, thickness, corner(args.text("kind")?))?;
    finish(
        &node,
        sound(made, &format!("the shell of {thickness} mm"))?,
        false,
    )
}

/// `split(keepTop, keepBottom)` or `split(splitter)`.
pub(super) fn split(args: &Args<'_>) -> Result<Value> {
    let node = args.on()?;
    let solid = node.solid()?;
    if args.given("splitter") {
        let objects = args.objects("splitter")?;
        let tools: Vec<&Shape> = objects
            .iter()
            .filter_map(|o| o.as_shape().map(Rc::as_ref))
            .collect();
        return Ok(Value::Node(node.next_shape(solid.split_by(&tools)?)));
    }
    let (top, bottom) = (args.flag("keepTop")?, args.flag("keepBottom")?);
    if !top && !bottom {
        return Err(KernelError::refused(
            "a split keeps something: give keepTop = True, keepBottom = True or both",
        ));
    }
    let reach = through(&node)? * 10.0;
    let far = reach + node.to_local(solid.center()?.into()).norm();
    let half = |up: bool| -> Result<Shape> {
        let low = if up { 0.0 } else { -far };
        let at = node.plane * Placement::translation(-far, -far, low);
        let side = Shape::cuboid(&at.frame(&Frame::WORLD), [2.0 * far, 2.0 * far, far])?;
        cut(&solid, &[side], None)
    };
    let mut objects = Vec::new();
    if top {
        objects.push(Object::shape(half(false)?));
    }
    if bottom {
        objects.push(Object::shape(half(true)?));
    }
    Ok(Value::Node(node.next(objects)))
}

/// `section(height)`.
pub(super) fn section(args: &Args<'_>) -> Result<Value> {
    let node = args.on()?;
    let solid = node.solid()?;
    let reach = through(&node)? * 2.0 + node.to_local(solid.center()?.into()).norm();
    let at = node.plane * Placement::translation(0.0, 0.0, args.real("height")?);
    let corner = |x: f64, y: f64| at.point([x * reach, y * reach, 0.0]);
    let outline = [
        corner(-1.0, -1.0),
        corner(1.0, -1.0),
        corner(1.0, 1.0),
        corner(-1.0, 1.0),
    ];
    let face = Shape::face(&Shape::polyline_wire(&outline, true)?, &[])?;
    Ok(Value::Node(node.next_shape(solid.shared(&[&face], None)?)))
}
