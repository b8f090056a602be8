//! Drawing: edges and wires in a workplane.

use std::rc::Rc;

use assemcad_model::angle::sin_cos_deg;
use assemcad_model::frame::Placement;
use assemcad_model::language::{Outline, Segment};

use super::args::Args;
use super::each::at_each_place;
use super::value::{Node, Object, Value, Vector};
use crate::brep::{Corner, Spline, Topology};
use crate::error::{KernelError, Result};
use crate::shape::Shape;

/// Below this a chord leaves no room between a radius and half the chord: CadQuery's.
const TOLERANCE: f64 = 1e-6;

/// The default of CadQuery for points of a spline.
const SPLINE_TOLERANCE: f64 = 1e-6;

/// Where the next edge begins, in the world.
pub(super) fn current(node: &Node) -> Result<Vector> {
    match node.objects.last() {
        None => Ok(node.origin()),
        Some(Object::Point(point)) => Ok(*point),
        Some(object) => {
            if let Some(edge) = object.of(Topology::Edge)? {
                return Ok(edge.end_point()?.into());
            }
            if let Some(vertex) = object.of(Topology::Vertex)? {
                return Ok(vertex.center()?.into());
            }
            Err(KernelError::refused(format!(
                "there is no current point: the stack ends with {}; begin with moveTo(x, y)",
                object.describe()
            )))
        }
    }
}

fn current_local(node: &Node) -> Result<Vector> {
    Ok(node.to_local(current(node)?))
}

/// Remembers an edge for the wire to come.
fn pend_edge(node: &Node, edge: &Rc<Shape>) -> Result<()> {
    let start = node.to_local(edge.start_point()?.into());
    let mut context = node.context.borrow_mut();
    context.edges.push(Rc::clone(edge));
    context.first_point.get_or_insert(start);
    Ok(())
}

/// The next link with an edge on its stack, drawn unless it is for construction.
fn drawn(args: &Args<'_>, node: &Rc<Node>, edge: Shape) -> Result<Value> {
    let construction = args.given("forConstruction") && args.flag("forConstruction")?;
    let as_wire = args.given("makeWire") && args.flag("makeWire")?;
    let shape = Rc::new(if as_wire {
        Shape::wire(&[&edge])?
    } else {
        edge
    });
    if as_wire && !construction {
        node.context.borrow_mut().wires.push(Rc::clone(&shape));
    } else if !construction {
        pend_edge(node, &shape)?;
    }
    Ok(Value::Node(node.next(vec![Object::Shape(shape)])))
}

/// `moveTo` and `move`.
pub(super) fn move_to(args: &Args<'_>) -> Result<Value> {
    let node = args.on()?;
    let local = if args.given("xDist") {
        current_local(&node)? + Vector::new(args.real("xDist")?, args.real("yDist")?, 0.0)
    } else {
        Vector::new(args.real("x")?, args.real("y")?, 0.0)
    };
    let point = Object::Point(node.to_world(local));
    Ok(Value::Node(node.next(vec![point])))
}

/// All the calls that draw one line.
pub(super) fn line(args: &Args<'_>, short: &str) -> Result<Value> {
    let node = args.on()?;
    let here = current_local(&node)?;
    let polar = || -> Result<Vector> {
        let (sin, cos) = sin_cos_deg(args.real("angle")?);
        let distance = args.real("distance")?;
        Ok(Vector::new(cos * distance, sin * distance, 0.0))
    };
    let end = match short {
        "lineTo" => Vector::new(args.real("x")?, args.real("y")?, 0.0),
        "line" => here + Vector::new(args.real("xDist")?, args.real("yDist")?, 0.0),
        "hLine" => here + Vector::new(args.real("distance")?, 0.0, 0.0),
        "vLine" => here + Vector::new(0.0, args.real("distance")?, 0.0),
        "hLineTo" => Vector::new(args.real("xCoord")?, here.y, 0.0),
        "vLineTo" => Vector::new(here.x, args.real("yCoord")?, 0.0),
        "polarLine" => here + polar()?,
        _ => polar()?,
    };
    // The start is the current point itself, also where it is not in the plane.
    let edge = Shape::line_edge(current(&node)?.into(), node.to_world(end).into())?;
    drawn(args, &node, edge)
}

/// `polyline(points)`.
pub(super) fn polyline(args: &Args<'_>) -> Result<Value> {
    let node = args.on()?;
    let mut points: Vec<Vector> = Vec::new();
    if args.flag("includeCurrent")? {
        points.push(current(&node)?);
    }
    points.extend(
        args.vectors("listOfXYTuple")?
            .into_iter()
            .map(|p| node.to_world(p)),
    );
    let construction = args.flag("forConstruction")?;
    Ok(Value::Node(lines_through(&node, &points, construction)?))
}

fn lines_through(node: &Rc<Node>, points: &[Vector], construction: bool) -> Result<Rc<Node>> {
    let mut edges = Vec::new();
    for pair in points.windows(2) {
        if let [from, to] = pair {
            let shape = Rc::new(Shape::line_edge((*from).into(), (*to).into())?);
            if !construction {
                pend_edge(node, &shape)?;
            }
            edges.push(Object::Shape(shape));
        }
    }
    if edges.is_empty() {
        return Err(KernelError::refused("a polyline has at least two points"));
    }
    Ok(node.next(edges))
}

/// `threePointArc(point1, point2)`.
pub(super) fn three_point_arc(args: &Args<'_>) -> Result<Value> {
    let (via, end) = (args.vector("point1")?, args.vector("point2")?);
    arc_through(args, &args.on()?, via, end)
}

fn arc_through(args: &Args<'_>, node: &Rc<Node>, via: Vector, end: Vector) -> Result<Value> {
    let edge = Shape::arc_edge(
        current(node)?.into(),
        node.to_world(via).into(),
        node.to_world(end).into(),
    )?;
    drawn(args, node, edge)
}

/// `sagittaArc(endPoint, sag)`: a positive rise lies to the left of the way.
pub(super) fn sagitta_arc(args: &Args<'_>) -> Result<Value> {
    rise(args, args.real("sag")?)
}

fn rise(args: &Args<'_>, sag: f64) -> Result<Value> {
    let node = args.on()?;
    let (start, end) = (current_local(&node)?, args.vector("endPoint")?);
    let chord = end - start;
    if chord.norm() < TOLERANCE {
        return Err(KernelError::refused("the arc ends where it begins"));
    }
    let along = chord.normalize();
    let left = Vector::new(-along.y, along.x, 0.0);
    arc_through(args, &node, (start + end) * 0.5 + left * sag, end)
}

/// `radiusArc(endPoint, radius)`.
pub(super) fn radius_arc(args: &Args<'_>) -> Result<Value> {
    let node = args.on()?;
    let radius = args.real("radius")?;
    let half = (args.vector("endPoint")? - current_local(&node)?).norm() / 2.0;
    let rest = radius * radius - half * half;
    // A half circle may miss by a last digit.
    let inner = if rest.abs() < TOLERANCE {
        0.0
    } else if rest < 0.0 {
        return Err(KernelError::refused(format!(
            "an arc of radius {radius} mm does not reach its end point, which is {} mm away: the \
             radius is at least {half} mm",
            2.0 * half
        )));
    } else {
        rest.sqrt()
    };
    let sag = radius.abs() - inner;
    rise(args, if radius > 0.0 { sag } else { -sag })
}

/// `tangentArcPoint(endpoint, relative)`.
pub(super) fn tangent_arc(args: &Args<'_>) -> Result<Value> {
    let node = args.on()?;
    let last = node
        .objects
        .last()
        .map(|object| object.of(Topology::Edge))
        .transpose()?
        .flatten();
    let Some(edge) = last else {
        return Err(KernelError::refused(
            "tangentArcPoint goes on from an edge, and none has been drawn before it",
        ));
    };
    let mut end = args.vector("endpoint")?;
    if args.flag("relative")? {
        end += current_local(&node)?;
    }
    let arc = Shape::tangent_arc_edge(
        edge.end_point()?,
        edge.tangent_at(1.0)?,
        node.to_world(end).into(),
    )?;
    drawn(args, &node, arc)
}

fn points(args: &Args<'_>, node: &Node) -> Result<Vec<[f64; 3]>> {
    let mut all = Vec::new();
    if args.flag("includeCurrent")? {
        all.push(current(node)?.into());
    }
    let listed = args.vectors("listOfXYTuple")?;
    all.extend(
        listed
            .into_iter()
            .map(|p| -> [f64; 3] { node.to_world(p).into() }),
    );
    Ok(all)
}

/// `spline(points, tangents, periodic, parameters, scale, tol)`.
pub(super) fn spline(args: &Args<'_>) -> Result<Value> {
    let node = args.on()?;
    let points = points(args, &node)?;
    let tangents = args
        .read::<Vec<Option<[f64; 3]>>>("tangents")?
        .map(|tangents| {
            tangents
                .into_iter()
                .map(|t| t.map(|t| node.plane.direction(t)))
                .collect::<Vec<_>>()
        });
    let parameters = args.read::<Vec<f64>>("parameters")?;
    let edge = Shape::spline_edge(&Spline {
        points: &points,
        tangents: tangents.as_deref(),
        periodic: args.flag("periodic")?,
        parameters: parameters.as_deref(),
        scale: args.flag("scale")?,
        tolerance: args.real_or_none("tol")?.unwrap_or(SPLINE_TOLERANCE),
    })?;
    drawn(args, &node, edge)
}

/// `bezier(points)`.
pub(super) fn bezier(args: &Args<'_>) -> Result<Value> {
    let node = args.on()?;
    let edge = Shape::bezier_edge(&points(args, &node)?)?;
    drawn(args, &node, edge)
}

/// `ellipseArc(...)`.
pub(super) fn ellipse_arc(args: &Args<'_>) -> Result<Value> {
    let node = args.on()?;
    let center = current(&node)?;
    let (sin, cos) = sin_cos_deg(args.real("rotation_angle")?);
    let [x, y, z] = node.plane.axes();
    let at = super::chain::plane(center, x * cos + y * sin, z)?;
    let mut edge = Shape::ellipse_arc_edge(
        &at,
        args.real("x_radius")?,
        args.real("y_radius")?,
        args.real("angle1")?,
        args.real("angle2")?,
        args.count("sense")? > 0,
    )?;
    if args.flag("startAtCurrent")? {
        let by = center - Vector::from(edge.start_point()?);
        edge = edge.moved(&Placement::translation(by.x, by.y, by.z))?;
    }
    drawn(args, &node, edge)
}

/// `wire()`: the edges drawn so far as a wire; what else is on the stack stays.
pub(super) fn wire(args: &Args<'_>) -> Result<Value> {
    let construction = args.flag("forConstruction")?;
    Ok(Value::Node(wired(&args.on()?, construction)?))
}

pub(super) fn wired(node: &Rc<Node>, construction: bool) -> Result<Rc<Node>> {
    let edges = core::mem::take(&mut node.context.borrow_mut().edges);
    if edges.is_empty() {
        return Ok(Rc::clone(node));
    }
    let all: Vec<&Shape> = edges.iter().map(Rc::as_ref).collect();
    let shape = Rc::new(Shape::wire(&all)?);
    {
        let mut context = node.context.borrow_mut();
        context.first_point = None;
        if !construction {
            context.wires.push(Rc::clone(&shape));
        }
    }
    let mut objects = Vec::new();
    for object in &node.objects {
        if object.of(Topology::Edge)?.is_none() {
            objects.push(object.clone());
        }
    }
    objects.push(Object::Shape(shape));
    Ok(node.next(objects))
}

/// `close()`.
pub(super) fn close(args: &Args<'_>) -> Result<Value> {
    let node = args.on()?;
    let end = current_local(&node)?;
    let first = node.context.borrow().first_point;
    let Some(start) = first else {
        return Err(KernelError::refused(
            "there is nothing to close: no edge has been drawn since the last wire",
        ));
    };
    if (end - start).norm() > TOLERANCE {
        let ends = [node.to_world(end), node.to_world(start)];
        lines_through(&node, &ends, false)?;
    }
    Ok(Value::Node(wired(&node, false)?))
}

/// Everything drawn and not used yet, joined where it meets.
fn consolidated(node: &Node) -> Result<Vec<Rc<Shape>>> {
    let context = node.context.borrow();
    let all: Vec<&Shape> = context
        .edges
        .iter()
        .chain(&context.wires)
        .map(Rc::as_ref)
        .collect();
    if all.is_empty() {
        return Ok(Vec::new());
    }
    Ok(Shape::connected_wires(&all)?
        .into_iter()
        .map(Rc::new)
        .collect())
}

/// `consolidateWires()`.
pub(super) fn consolidate(node: &Rc<Node>) -> Result<Rc<Node>> {
    let wires = consolidated(node)?;
    if wires.is_empty() {
        return Ok(Rc::clone(node));
    }
    {
        let mut context = node.context.borrow_mut();
        context.edges.clear();
        context.first_point = None;
        context.wires.clone_from(&wires);
    }
    Ok(node.next(super::chain::bodies(wires)))
}

/// `mirrorX()` and `mirrorY()`: what is drawn, turned half about the axis, joined with itself.
pub(super) fn mirror_in_plane(args: &Args<'_>, about_x: bool) -> Result<Value> {
    let node = args.on()?;
    let joined = consolidate(&wired(&node, false)?)?;
    let [x, y, _] = node.plane.axes();
    let half_turn = Placement::rotation_about(
        node.origin().into(),
        if about_x { x } else { y }.into(),
        180.0,
    )
    .map_err(|e| KernelError::refused(e.to_string()))?;
    for wire in super::chain::parts(&joined, Topology::Wire)? {
        let image = Rc::new(wire.moved(&half_turn)?.baked()?);
        joined.context.borrow_mut().wires.push(image);
    }
    Ok(Value::Node(consolidate(&joined)?))
}

/// `toPending()`.
pub(super) fn to_pending(args: &Args<'_>) -> Result<Value> {
    let node = args.on()?;
    for object in &node.objects {
        if let Some(wire) = object.of(Topology::Wire)? {
            node.context.borrow_mut().wires.push(Rc::clone(wire));
        } else if let Some(edge) = object.of(Topology::Edge)? {
            node.context.borrow_mut().edges.push(Rc::clone(edge));
        }
    }
    Ok(Value::Node(node))
}

/// `offset2D(d, kind)`.
pub(super) fn offset(args: &Args<'_>) -> Result<Value> {
    let node = args.on()?;
    let corner = corner(args.text("kind")?);
    let (distance, construction) = (args.real("d")?, args.flag("forConstruction")?);
    let wires = consolidated(&node)?;
    if wires.is_empty() {
        return Err(KernelError::refused(
            "offset2D moves what is drawn, and nothing is",
        ));
    }
    let mut found = Vec::new();
    for wire in wires {
        found.extend(wire.offset_2d(distance, corner)?.into_iter().map(Rc::new));
    }
    {
        let mut context = node.context.borrow_mut();
        context.edges.clear();
        context.wires = if construction {
            Vec::new()
        } else {
            found.clone()
        };
    }
    let objects = found.into_iter().map(Object::Shape).collect();
    Ok(Value::Node(node.next(objects)))
}

pub(super) fn corner(word: &str) -> Corner {
    match word {
        "intersection" => Corner::Intersection,
        "tangent" => Corner::Tangent,
        _ => Corner::Arc,
    }
}

/// A closed outline at each point of the stack.
fn outlines(args: &Args<'_>, wire: Shape) -> Result<Value> {
    let construction = args.given("forConstruction") && args.flag("forConstruction")?;
    let node = args.on()?;
    Ok(Value::Node(at_each_place(&node, &wire, construction)?))
}

/// `rect(xLen, yLen, centered)`.
pub(super) fn rect(args: &Args<'_>) -> Result<Value> {
    let (x, y) = (args.real("xLen")?, args.real("yLen")?);
    let [cx, cy] = args.flags("centered")?;
    let (left, low) = (
        if cx { -x / 2.0 } else { 0.0 },
        if cy { -y / 2.0 } else { 0.0 },
    );
    let corners = [
        [left, low, 0.0],
        [left + x, low, 0.0],
        [left + x, low + y, 0.0],
        [left, low + y, 0.0],
    ];
    outlines(args, Shape::polyline_wire(&corners, true)?)
}

/// `circle(radius)`.
pub(super) fn circle(args: &Args<'_>) -> Result<Value> {
    let edge = Shape::circle_edge(&Placement::IDENTITY, args.length("radius")?)?;
    outlines(args, Shape::wire(&[&edge])?)
}

/// `ellipse(x_radius, y_radius, rotation_angle)`.
pub(super) fn ellipse(args: &Args<'_>) -> Result<Value> {
    let edge = Shape::ellipse_edge(
        &Placement::IDENTITY,
        args.length("x_radius")?,
        args.length("y_radius")?,
        args.real("rotation_angle")?,
    )?;
    outlines(args, Shape::wire(&[&edge])?)
}

/// Most sides of a polygon.
const MOST_SIDES: i32 = 10_000;

/// `polygon(nSides, diameter, circumscribed)`.
pub(super) fn polygon(args: &Args<'_>) -> Result<Value> {
    let sides = args.count("nSides")?;
    if !(3..=MOST_SIDES).contains(&sides) {
        return Err(KernelError::refused(format!(
            "a polygon has 3 to {MOST_SIDES} sides, not {sides}"
        )));
    }
    let step = 360.0 / f64::from(sides);
    let mut radius = args.length("diameter")? / 2.0;
    let mut first = 0.0;
    if args.flag("circumscribed")? {
        radius /= sin_cos_deg(step / 2.0).1;
        first = step / 2.0;
    }
    let corners: Vec<[f64; 3]> = (0..sides)
        .map(|i| {
            let (sin, cos) = sin_cos_deg(first + step * f64::from(i));
            [radius * cos, radius * sin, 0.0]
        })
        .collect();
    outlines(args, Shape::polyline_wire(&corners, true)?)
}

/// `slot2D(length, diameter, angle)`.
pub(super) fn slot(args: &Args<'_>) -> Result<Value> {
    let (length, diameter) = (args.length("length")?, args.length("diameter")?);
    if length <= diameter {
        return Err(KernelError::refused(format!(
            "a slot of length {length} mm is no longer than its diameter {diameter} mm: the length \
             is over all"
        )));
    }
    let r = diameter / 2.0;
    let h = length / 2.0 - r;
    let (a, b, c, d) = ([-h, r, 0.0], [h, r, 0.0], [h, -r, 0.0], [-h, -r, 0.0]);
    let edges = [
        Shape::line_edge(a, b)?,
        Shape::arc_edge(b, [h + r, 0.0, 0.0], c)?,
        Shape::line_edge(c, d)?,
        Shape::arc_edge(d, [-h - r, 0.0, 0.0], a)?,
    ];
    let all: Vec<&Shape> = edges.iter().collect();
    let turned = Shape::wire(&all)?.moved(&Placement::rotation_z(args.real("angle")?))?;
    outlines(args, turned)
}

/// `outline(...)`: lines and arcs that the front end has computed.
pub(super) fn outline(args: &Args<'_>) -> Result<Value> {
    let outline = args
        .read::<Outline>("outline")?
        .ok_or_else(|| KernelError::refused("outline takes an outline"))?;
    outlines(args, outline_wire(&outline)?)
}

pub(super) fn outline_wire(outline: &Outline) -> Result<Shape> {
    let flat = |[x, y]: [f64; 2]| [x, y, 0.0];
    let mut here = outline.start;
    let mut edges = Vec::new();
    for segment in &outline.segments {
        let to = match segment {
            Segment::Line { to } => {
                edges.push(Shape::line_edge(flat(here), flat(*to))?);
                *to
            }
            Segment::Arc { via, to } => {
                edges.push(Shape::arc_edge(flat(here), flat(*via), flat(*to))?);
                *to
            }
        };
        here = to;
    }
    if here != outline.start {
        edges.push(Shape::line_edge(flat(here), flat(outline.start))?);
    }
    let all: Vec<&Shape> = edges.iter().collect();
    Shape::wire(&all)
}
