//! Solids of what is drawn, and what is done to the chain's solid.

use std::rc::Rc;

use assemcad_model::frame::Placement;

use super::args::Args;
use super::combine::{Mode, cut, joined};
use super::draw::wired;
use super::each::copies;
use super::value::{Node, Value, Vector};
use crate::brep::{Side, Sweep, Topology, Transition};
use crate::error::{KernelError, Result};
use crate::shape::Shape;

/// The faces that the next solid is made of: those on the stack, or what is drawn.
fn faces(node: &Node) -> Result<Vec<Shape>> {
    let mut found = Vec::new();
    for shape in node.shapes() {
        match shape.topology()? {
            Topology::Face => found.push(shape.try_clone()?),
            Topology::Compound => {
                for child in shape.children()? {
                    if child.topology()? == Topology::Face {
                        found.push(child);
                    }
                }
            }
            _ => {}
        }
    }
    if !found.is_empty() {
        return Ok(found);
    }
    let wires = drawn(node)?;
    let all: Vec<&Shape> = wires.iter().map(Rc::as_ref).collect();
    Shape::faces_from_wires(&all)
}

/// What is drawn, which is used up by this.
fn drawn(node: &Node) -> Result<Vec<Rc<Shape>>> {
    let mut context = node.context.borrow_mut();
    let wires = core::mem::take(&mut context.wires);
    if wires.is_empty() {
        return Err(KernelError::refused(if context.edges.is_empty() {
            "nothing is drawn: draw a closed outline before, for example by rect, circle or \
             polyline(...).close()"
        } else {
            "the outline is not closed: end it with close()"
        }));
    }
    Ok(wires)
}

/// How far a solid goes.
enum Until {
    Length(f64),
    Next,
    Last,
    Face(Shape),
}

fn until(args: &Args<'_>) -> Result<Until> {
    if args.reference("until").is_some() {
        for object in args.objects("until")? {
            if let Some(face) = object.of(Topology::Face)? {
                return Ok(Until::Face(face.try_clone()?));
            }
        }
        return Err(KernelError::refused(
            "until is a length, \"next\", \"last\" or a face, and no face is on that stack",
        ));
    }
    match args.json("until").and_then(|json| json.as_str()) {
        Some("next") => Ok(Until::Next),
        Some("last") => Ok(Until::Last),
        Some(_) => Err(KernelError::refused(
            "until is a length, \"next\", \"last\" or a face",
        )),
        None => Ok(Until::Length(args.real("until")?)),
    }
}

/// What is drawn, moved by a length: one solid for each outline.
fn prisms(args: &Args<'_>, node: &Node, length: f64) -> Result<Vec<Shape>> {
    if length.abs() < crate::limits::SMALLEST {
        return Err(KernelError::refused(format!(
            "{length} mm is no length to extrude by"
        )));
    }
    let taper = args.real_or_none("taper")?.unwrap_or(0.0);
    let both = args.given("both") && args.flag("both")?;
    let way = node.z() * length;
    let mut made = Vec::new();
    for face in faces(node)? {
        plain_where_tapered(&face, taper)?;
        let there = face.extruded(way.into(), taper)?;
        made.push(if both {
            let back = face.extruded((-way).into(), taper)?;
            there.fused(&[&back], true, None)?
        } else {
            there
        });
    }
    Ok(made)
}

fn plain_where_tapered(face: &Shape, taper: f64) -> Result<()> {
    if taper != 0.0 && !face.inner_wires()?.is_empty() {
        return Err(KernelError::refused(
            "an outline with holes in it cannot be tapered: extrude the outer one, then cut the holes",
        ));
    }
    Ok(())
}

/// The chain's solid with what is drawn added or cut up to a face.
fn up_to(args: &Args<'_>, node: &Node, until: &Until, additive: bool) -> Result<Shape> {
    let taper = args.real_or_none("taper")?.unwrap_or(0.0);
    let both = args.flag("both")?;
    let solid = node.solid()?;
    let side = if additive { Side::Ahead } else { Side::Behind };
    let mut result = solid.try_clone()?;
    for face in faces(node)? {
        plain_where_tapered(&face, taper)?;
        let ways = if both {
            vec![node.z(), -node.z()]
        } else {
            vec![node.z()]
        };
        for way in ways {
            let limit = match until {
                Until::Face(limit) => limit.try_clone()?,
                Until::Next => limit(&solid, &face, way, side, !both, Pick::Next)?,
                _ => limit(&solid, &face, way, side, !both, Pick::Last)?,
            };
            result = Shape::extruded_until(&result, &face, Some(&limit), false, additive, taper)?;
        }
    }
    Ok(result)
}

#[derive(PartialEq)]
enum Pick {
    Next,
    Last,
}

/// The face of the solid that a line from the outline's centre meets.
fn limit(
    solid: &Shape,
    face: &Shape,
    way: Vector,
    side: Side,
    turn: bool,
    pick: Pick,
) -> Result<Shape> {
    let from = face.center()?;
    let mut met = solid.faces_hit_by_line(from, way.into(), side)?;
    if met.is_empty() && turn {
        // The plane may look the wrong way.
        met = solid.faces_hit_by_line(from, (-way).into(), side)?;
    }
    // Inside of the solid the first face is only where it ends: the next one is behind it.
    let skip = usize::from(
        pick == Pick::Next && side == Side::Ahead && met.len() > 1 && inside(solid, face)?,
    );
    let found = match pick {
        Pick::Next => met.into_iter().nth(skip),
        Pick::Last => met.pop(),
    };
    found.ok_or_else(|| {
        KernelError::refused(
            "no face of the solid lies on the way of the outline: check which way the workplane looks",
        )
    })
}

fn inside(solid: &Shape, face: &Shape) -> Result<bool> {
    use crate::query::Side::Inside;
    let center = face.outer_wire()?.center()?;
    Ok(solid.classify(&[center], 1e-6)?.first() == Some(&Inside))
}

/// `extrude(until, combine, clean, both, taper)`.
pub(super) fn extrude(args: &Args<'_>) -> Result<Value> {
    let node = args.on()?;
    let (mode, clean) = (Mode::of(args)?, args.flag("clean")?);
    match (until(args)?, mode) {
        (Until::Length(length), Mode::Cut) => cut_by(args, &node, length, clean),
        (Until::Length(length), _) => {
            let made = prisms(args, &node, length)?;
            joined(args, &node, made)
        }
        (_, Mode::Apart) => Err(KernelError::refused(
            "what is extruded up to a face is one with the solid: combine cannot be False",
        )),
        (face, Mode::Cut) => finish(&node, up_to(args, &node, &face, false)?, clean),
        (face, Mode::Add) => {
            let made = up_to(args, &node, &face, true)?;
            joined(args, &node, vec![made])
        }
    }
}

pub(super) fn finish(node: &Rc<Node>, shape: Shape, clean: bool) -> Result<Value> {
    let shape = if clean { shape.cleaned()? } else { shape };
    Ok(Value::Node(node.next_shape(shape)))
}

fn cut_by(args: &Args<'_>, node: &Rc<Node>, length: f64, clean: bool) -> Result<Value> {
    let tools = prisms(args, node, length)?;
    finish(node, cut(&node.solid()?, &tools, None)?, clean)
}

/// `cutBlind(until, clean, both, taper)`.
pub(super) fn cut_blind(args: &Args<'_>) -> Result<Value> {
    let (node, clean) = (args.on()?, args.flag("clean")?);
    match until(args)? {
        Until::Length(length) => cut_by(args, &node, length, clean),
        face => finish(&node, up_to(args, &node, &face, false)?, clean),
    }
}

/// `cutThruAll(clean, taper)`.
pub(super) fn cut_through(args: &Args<'_>) -> Result<Value> {
    let node = args.on()?;
    let taper = args.real("taper")?;
    let mut result = node.solid()?;
    for face in faces(&node)? {
        plain_where_tapered(&face, taper)?;
        result = Shape::extruded_until(&result, &face, None, true, false, -taper)?;
    }
    finish(&node, result, args.flag("clean")?)
}

/// `twistExtrude(distance, angleDegrees)`.
pub(super) fn twist(args: &Args<'_>) -> Result<Value> {
    let node = args.on()?;
    let way = node.z() * args.real("distance")?;
    let mut made = Vec::new();
    for face in faces(&node)? {
        made.push(face.twisted(node.origin().into(), way.into(), args.real("angleDegrees")?)?);
    }
    joined(args, &node, made)
}

/// `revolve(angleDegrees, axisStart, axisEnd)`.
pub(super) fn revolve(args: &Args<'_>) -> Result<Value> {
    let node = args.on()?;
    let angle = args.real("angleDegrees")?;
    let turns = (angle / 360.0).floor();
    let mut angle = angle - 360.0 * turns;
    if angle == 0.0 {
        angle = 360.0;
    }
    let start = node.to_world(args.vector_or_none("axisStart")?.unwrap_or_default());
    let end = match args.vector_or_none("axisEnd")? {
        Some(end) => node.to_world(end),
        // CadQuery's rule, kept as it is: it looks at the start's y in the world.
        None if start.y != 0.0 => node.to_world(Vector::new(0.0, start.y, 0.0)),
        None => node.to_world(Vector::y()),
    };
    if (end - start).norm() < crate::limits::SMALLEST {
        return Err(KernelError::refused(
            "the axis ends where it begins: give axisStart and axisEnd, both in the workplane",
        ));
    }
    let mut made = Vec::new();
    for face in faces(&node)? {
        made.push(face.turned(start.into(), end.into(), angle)?);
    }
    joined(args, &node, made)
}

fn curve(args: &Args<'_>, name: &str) -> Result<Rc<Shape>> {
    let objects = match args.node(name)? {
        Some(node) => wired(&node, false)?.objects.clone(),
        None => args.objects(name)?,
    };
    match objects.first() {
        Some(object) => {
            if let Some(found) = object.of(Topology::Wire)? {
                return Ok(Rc::clone(found));
            }
            if let Some(found) = object.of(Topology::Edge)? {
                return Ok(Rc::clone(found));
            }
            Err(KernelError::refused(format!(
                "{name} is a wire or an edge, and its stack begins with {}",
                object.describe()
            )))
        }
        None => Err(KernelError::refused(format!("nothing is drawn in {name}"))),
    }
}

/// `sweep(path, multisection, makeSolid, isFrenet, transition, normal, auxSpine)`.
pub(super) fn sweep(args: &Args<'_>) -> Result<Value> {
    let node = args.on()?;
    let path = curve(args, "path")?;
    let spine = if args.given("auxSpine") {
        Some(curve(args, "auxSpine")?)
    } else {
        None
    };
    let how = Sweep {
        path: &path,
        solid: args.flag("makeSolid")?,
        frenet: args.flag("isFrenet")?,
        transition: match args.text("transition")? {
            "round" => Transition::Round,
            "transformed" => Transition::Transformed,
            _ => Transition::Right,
        },
        normal: args.vector_or_none("normal")?.map(Into::into),
        aux_spine: spine.as_deref(),
    };
    let several = args.flag("multisection")?
        || (args.given("sweepAlongWires") && args.flag("sweepAlongWires")?);
    let made = if several {
        let sections = drawn(&node)?;
        let sections: Vec<&Shape> = sections.iter().map(Rc::as_ref).collect();
        vec![Shape::swept_multi(&sections, &how)?]
    } else {
        faces(&node)?
            .iter()
            .map(|face| face.swept(&how))
            .collect::<Result<Vec<Shape>>>()?
    };
    let made = made
        .into_iter()
        .map(|made| sound(made, "the sweep"))
        .collect::<Result<Vec<Shape>>>()?;
    joined(args, &node, made)
}

/// `loft(ruled)`: through the drawn wires, or the faces and vertices of the stack.
pub(super) fn loft(args: &Args<'_>) -> Result<Value> {
    let node = args.on()?;
    let mut sections: Vec<Rc<Shape>> = core::mem::take(&mut node.context.borrow_mut().wires);
    if sections.is_empty() {
        for shape in node.shapes() {
            match shape.topology()? {
                Topology::Face => sections.push(Rc::new(shape.outer_wire()?)),
                Topology::Vertex => sections.push(Rc::clone(shape)),
                _ => {}
            }
        }
    }
    if sections.len() < 2 {
        return Err(KernelError::refused(format!(
            "a loft goes through at least two outlines, and {} is drawn",
            sections.len()
        )));
    }
    let all: Vec<&Shape> = sections.iter().map(Rc::as_ref).collect();
    let made = sound(Shape::lofted(&all, args.flag("ruled")?, true)?, "the loft")?;
    joined(args, &node, vec![made])
}

/// Cuts the same tool at each point of the stack.
fn drilled(args: &Args<'_>, tool: &Shape) -> Result<Value> {
    let node = args.on()?;
    let solid = node.solid()?;
    let tools = copies(&node, tool)?;
    finish(&node, cut(&solid, &tools, None)?, args.flag("clean")?)
}

/// A depth that goes through everything: the diagonal of the solid's box.
pub(super) fn through(node: &Node) -> Result<f64> {
    let extent = node.solid()?.extent()?;
    Ok(Vector::from(extent.size()).norm())
}

fn depth(args: &Args<'_>) -> Result<f64> {
    match args.real_or_none("depth")? {
        Some(_) => args.length("depth"),
        None => through(&*args.on()?),
    }
}

/// A cylinder from the plane downwards.
pub(super) fn drill(diameter: f64, depth: f64) -> Result<Shape> {
    Shape::cylinder_part(&Placement::rotation_x(180.0), diameter / 2.0, depth, 360.0)
}

/// `hole(diameter, depth)`.
pub(super) fn hole(args: &Args<'_>) -> Result<Value> {
    drilled(args, &drill(args.length("diameter")?, depth(args)?)?)
}

/// `cboreHole(diameter, cboreDiameter, cboreDepth, depth)`.
pub(super) fn cbore(args: &Args<'_>) -> Result<Value> {
    let hole = drill(args.length("diameter")?, depth(args)?)?;
    let wide = drill(args.length("cboreDiameter")?, args.length("cboreDepth")?)?;
    drilled(args, &hole.fused(&[&wide], false, None)?)
}

/// The cone of a countersink, its base in the plane.
pub(super) fn countersink(diameter: f64, angle: f64) -> Result<(Shape, f64)> {
    if !(angle > 0.0 && angle < 180.0) {
        return Err(KernelError::refused(format!(
            "a countersink's whole angle is over 0 and below 180 degrees, not {angle}"
        )));
    }
    let (sin, cos) = assemcad_model::angle::sin_cos_deg(angle / 2.0);
    let height = diameter / 2.0 * cos / sin;
    let at = Placement::rotation_x(180.0);
    Ok((
        Shape::cone_part(&at, diameter / 2.0, 0.0, height, 360.0)?,
        height,
    ))
}

/// `cskHole(diameter, cskDiameter, cskAngle, depth)`.
pub(super) fn csk(args: &Args<'_>) -> Result<Value> {
    let hole = drill(args.length("diameter")?, depth(args)?)?;
    let (cone, _) = countersink(args.length("cskDiameter")?, args.real("cskAngle")?)?;
    drilled(args, &hole.fused(&[&cone], false, None)?)
}

/// The shape, where it is valid: these verbs may leave one that is not, and nothing made of it later
/// would be.
pub(super) fn sound(made: Shape, what: &str) -> Result<Shape> {
    if made.is_valid()? {
        Ok(made)
    } else {
        Err(KernelError::invalid(format!(
            "{what} leaves no valid solid: faces cross each other or the boundary is open"
        )))
    }
}
