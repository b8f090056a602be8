//! How a new solid joins the chain's, and the union that never falls apart in silence.

use std::rc::Rc;

use super::args::Args;
use super::value::{Node, Object, Value, Vector};
use crate::booleans::{Kind, judge};
use crate::brep::{Form, Topology};
use crate::error::{KernelError, Result};
use crate::shape::Shape;

/// The largest gap, in mm, that a union closes.
const CLOSES: f64 = 0.01;

/// How far, in mm, what closes a gap reaches into both solids.
const INTO: f64 = 1e-3;

/// What becomes of a new solid.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Mode {
    Add,
    Cut,
    Apart,
}

impl Mode {
    pub(super) fn of(args: &Args<'_>) -> Result<Self> {
        match args.text("combine")? {
            "add" => Ok(Self::Add),
            "cut" => Ok(Self::Cut),
            "none" => Ok(Self::Apart),
            _ => Err(KernelError::refused("combine is add, cut or none")),
        }
    }
}

fn all(shapes: &[Shape]) -> Vec<&Shape> {
    shapes.iter().collect()
}

fn cleaned(shape: Shape, clean: bool) -> Result<Shape> {
    if clean { shape.cleaned() } else { Ok(shape) }
}

/// The next link: the made shapes joined to the chain's solid as the mode says.
fn combined(node: &Rc<Node>, made: Vec<Shape>, mode: Mode, clean: bool) -> Result<Rc<Node>> {
    if mode == Mode::Apart {
        let objects = made
            .into_iter()
            .map(|shape| Ok(Object::shape(cleaned(shape, clean)?)))
            .collect::<Result<Vec<Object>>>()?;
        return Ok(node.next(objects));
    }
    let base = node.find_solid()?;
    let tool = Shape::compound(&all(&made))?;
    let result = match (base, mode) {
        (Some(base), Mode::Cut) => cut(&base, &[tool], None)?,
        (Some(base), _) => fused(&base, &[tool], false, None)?,
        // One shape alone is itself; several may overlap.
        (None, Mode::Add) if made.len() > 1 => tool.fused(&[], false, None)?,
        (None, _) => tool,
    };
    Ok(node.next_shape(cleaned(result, clean)?))
}

/// The same, as the call's own `combine` and `clean` say.
pub(super) fn joined(args: &Args<'_>, node: &Rc<Node>, made: Vec<Shape>) -> Result<Value> {
    let (mode, clean) = (Mode::of(args)?, args.flag("clean")?);
    Ok(Value::Node(combined(node, made, mode, clean)?))
}

/// Tolerances in mm with which a boolean is tried again when its result cannot be right: the kernel
/// then takes for one what it had cut into slivers.
const AGAIN: [Option<f64>; 3] = [None, Some(1e-6), Some(1e-5)];

/// A boolean, held against what volumes and points say; tried again where it is wrong.
///
/// # Errors
/// What is wrong with the first try, when none is right.
fn tried(
    kind: Kind,
    base: &Shape,
    others: &[Shape],
    tolerance: Option<f64>,
    make: impl Fn(Option<f64>) -> Result<Shape>,
) -> Result<Shape> {
    // With a tolerance of the script's own the volumes need not add up.
    if tolerance.is_some() {
        return make(tolerance);
    }
    let mut first = None;
    for again in AGAIN {
        match make(again).and_then(|result| judged(kind, base, others, result)) {
            Ok(result) => return Ok(result),
            // What is asked for is at fault, and no tolerance mends it.
            Err(error) if error.kind == crate::error::Kind::Refused => return Err(error),
            Err(error) => {
                first.get_or_insert(error);
            }
        }
    }
    Err(first.unwrap_or_else(|| KernelError::internal("a boolean was not tried")))
}

/// The union as the kernel makes it.
fn fused(base: &Shape, others: &[Shape], glue: bool, tolerance: Option<f64>) -> Result<Shape> {
    tried(Kind::Fuse, base, others, tolerance, |tolerance| {
        base.fused(&all(others), glue, tolerance)
    })
}

pub(super) fn cut(base: &Shape, tools: &[Shape], tolerance: Option<f64>) -> Result<Shape> {
    let result = tried(Kind::Cut, base, tools, tolerance, |tolerance| {
        base.without(&all(tools), tolerance)
    })?;
    if result.parts(Topology::Solid)?.is_empty() {
        return Err(KernelError::refused("the cut leaves nothing of the solid"));
    }
    Ok(result)
}

fn shared(base: &Shape, others: &[Shape], tolerance: Option<f64>) -> Result<Shape> {
    let result = tried(Kind::Common, base, others, tolerance, |tolerance| {
        base.shared(&all(others), tolerance)
    })?;
    if result.parts(Topology::Solid)?.is_empty() {
        return Err(KernelError::refused(format!(
            "the solids have no volume in common{}",
            apart(base, others)?.0
        )));
    }
    Ok(result)
}

/// A boolean's result, held against its operands where they are solids.
fn judged(kind: Kind, base: &Shape, others: &[Shape], result: Shape) -> Result<Shape> {
    let mut solids = Vec::new();
    for other in others {
        solids.extend(other.parts(Topology::Solid)?);
    }
    if !solids.is_empty() {
        judge(kind, base, &Shape::compound(&all(&solids))?, &result)?;
    }
    Ok(result)
}

/// A clause with both boxes and the gap, and the gap itself in mm.
fn apart(base: &Shape, others: &[Shape]) -> Result<(String, f64)> {
    let other = Shape::compound(&all(others))?;
    let (gap, _, _) = base.distance_to(&other)?;
    let clause = format!(
        "; the first spans {} mm, the second {} mm, and the gap between them is {gap:.6} mm",
        base.extent()?,
        other.extent()?
    );
    Ok((clause, gap))
}

/// One solid of several: they overlap, or share a face, or a gap of at most [`CLOSES`] mm between
/// plane faces is closed.
///
/// # Errors
/// When not exactly one solid comes out; with both boxes and the gap.
pub(super) fn safe_union(
    base: &Shape,
    others: &[Shape],
    glue: bool,
    tolerance: Option<f64>,
) -> Result<Shape> {
    let count = |shape: &Shape| Ok::<usize, KernelError>(shape.parts(Topology::Solid)?.len());
    // Overlap: the plain union.
    let plain = fused(base, others, glue, tolerance)?;
    if count(&plain)? == 1 {
        return Ok(plain);
    }
    // A shared face that the plain union did not see as one.
    if !glue
        && let Ok(glued) = fused(base, others, true, tolerance)
        && count(&glued)? == 1
    {
        return Ok(glued);
    }
    // Small gaps: filled.
    if let Some(bridges) = bridges(&plain)? {
        let mut with = others
            .iter()
            .map(Shape::try_clone)
            .collect::<Result<Vec<Shape>>>()?;
        with.extend(bridges);
        let joined = fused(base, &with, false, tolerance)?;
        if count(&joined)? == 1 {
            return Ok(joined);
        }
    }
    let solids = plain.parts(Topology::Solid)?;
    let Some((first, rest)) = solids.split_first() else {
        return Err(KernelError::refused("the union holds no solid"));
    };
    let (clause, gap) = apart(first, rest)?;
    let mut text = format!(
        "the solids do not join: the union would be {} separate solids{clause}",
        solids.len()
    );
    text.push_str(if gap < 1e-9 {
        "; they touch only along an edge or in a point: let them overlap"
    } else {
        "; up to 0.01 mm between plane faces is closed: move one of them, let them overlap, or unite \
         what joins them first"
    });
    Err(KernelError::refused(text))
}

/// What fills the gaps between solids that are small enough; none where there is no such gap.
fn bridges(union: &Shape) -> Result<Option<Vec<Shape>>> {
    let solids = union.parts(Topology::Solid)?;
    let mut found = Vec::new();
    for (index, one) in solids.iter().enumerate() {
        for other in solids.iter().skip(index + 1) {
            found.extend(bridge(one, other)?);
        }
    }
    Ok((!found.is_empty()).then_some(found))
}

/// What lies between the plane faces of two solids that look at each other over a small gap, reaching
/// a little into both.
fn bridge(a: &Shape, b: &Shape) -> Result<Vec<Shape>> {
    let (gap, on_a, on_b) = a.distance_to(b)?;
    let way = Vector::from(on_b) - Vector::from(on_a);
    if !(gap > 0.0 && gap <= CLOSES) || way.norm() == 0.0 {
        return Ok(Vec::new());
    }
    let way = way.normalize();
    let from_a = slabs(a, way, on_a, gap)?;
    let from_b = slabs(b, -way, on_b, gap)?;
    if from_a.is_empty() || from_b.is_empty() {
        return Ok(Vec::new());
    }
    // Only where a face has the other one before it is there a gap to fill.
    Shape::compound(&all(&from_a))?
        .shared(&[&Shape::compound(&all(&from_b))?], None)?
        .parts(Topology::Solid)
}

/// The plane faces of a solid through a point that look along `way`, thickened across the gap.
fn slabs(solid: &Shape, way: Vector, point: [f64; 3], gap: f64) -> Result<Vec<Shape>> {
    let mut found = Vec::new();
    for face in solid.parts(Topology::Face)? {
        if face.form()? != Form::Plane {
            continue;
        }
        let normal = Vector::from(face.normal_at(None)?);
        let level = (Vector::from(face.center()?) - Vector::from(point)).dot(&normal);
        if normal.dot(&way) < 1.0 - 1e-6 || level.abs() > 1e-6 {
            continue;
        }
        let start = face.moved(&shift(-normal * INTO))?.baked()?;
        found.push(start.extruded((normal * (gap + 2.0 * INTO)).into(), 0.0)?);
    }
    Ok(found)
}

fn shift(by: Vector) -> assemcad_model::frame::Placement {
    assemcad_model::frame::Placement::translation(by.x, by.y, by.z)
}

/// The solids that an argument names.
fn operands(args: &Args<'_>, name: &str, solids_only: bool) -> Result<Vec<Shape>> {
    let mut found = Vec::new();
    for object in args.objects(name)? {
        let Some(shape) = object.as_shape() else {
            continue;
        };
        if solids_only {
            found.extend(shape.parts(Topology::Solid)?);
        } else {
            found.push(shape.try_clone()?);
        }
    }
    if found.is_empty() {
        return Err(KernelError::refused(format!(
            "{name} of {} has no solid on its stack",
            args.call.call
        )));
    }
    Ok(found)
}

fn join_tags(args: &Args<'_>, node: &Node, name: &str) -> Result<()> {
    if let Some(other) = args.node(name)? {
        super::chain::merge_tags(node, &other);
    }
    Ok(())
}

/// `union(toUnion, clean, glue, tol)`: the ports of both stay.
pub(super) fn union(args: &Args<'_>) -> Result<Value> {
    let node = args.on()?;
    let mut others = if args.given("toUnion") {
        join_tags(args, &node, "toUnion")?;
        operands(args, "toUnion", true)?
    } else {
        Vec::new()
    };
    let base = match node.find_solid()? {
        Some(base) => base,
        None if others.is_empty() => {
            return Err(KernelError::refused("there is nothing to unite"));
        }
        None => Shape::compound(&[&others.remove(0)])?,
    };
    let result = safe_union(
        &base,
        &others,
        args.flag("glue")?,
        args.real_or_none("tol")?,
    )?;
    let next = node.next_shape(cleaned(result, args.flag("clean")?)?);
    let mut ports = next.ports.as_ref().clone();
    if let Some(other) = args.node("toUnion")? {
        for port in other.ports.iter() {
            // A chain united with its own earlier link has the link's ports already.
            if ports.contains(port) {
                continue;
            }
            if ports.iter().any(|known| known.name == port.name) {
                return Err(KernelError::refused(format!(
                    "there would be two ports '{}' in this part: unite without_ports() of one, and \
                     take its ports back by with_ports_of(other, prefix)",
                    port.name
                )));
            }
            ports.push(port.clone());
        }
    }
    Ok(Value::Node(next.with_ports(ports)))
}

/// `cut(toCut)`.
pub(super) fn cut_call(args: &Args<'_>) -> Result<Value> {
    let node = args.on()?;
    let base = node.solid()?;
    join_tags(args, &node, "toCut")?;
    let tools = operands(args, "toCut", false)?;
    let result = cut(&base, &tools, args.real_or_none("tol")?)?;
    Ok(Value::Node(
        node.next_shape(cleaned(result, args.flag("clean")?)?),
    ))
}

/// `intersect(toIntersect)`.
pub(super) fn intersect(args: &Args<'_>) -> Result<Value> {
    let node = args.on()?;
    let base = node.solid()?;
    join_tags(args, &node, "toIntersect")?;
    let others = operands(args, "toIntersect", false)?;
    let result = shared(&base, &others, args.real_or_none("tol")?)?;
    Ok(Value::Node(
        node.next_shape(cleaned(result, args.flag("clean")?)?),
    ))
}

/// `combine()`: the objects of the stack as one.
pub(super) fn combine(args: &Args<'_>) -> Result<Value> {
    let node = args.on()?;
    let shapes: Vec<&Rc<Shape>> = node.shapes().collect();
    let Some((first, rest)) = shapes.split_first() else {
        return Err(KernelError::refused("there is nothing on the stack"));
    };
    let result = if rest.is_empty() {
        first.try_clone()?
    } else {
        let rest: Vec<&Shape> = rest.iter().map(|s| s.as_ref()).collect();
        first.fused(&rest, args.flag("glue")?, args.real_or_none("tol")?)?
    };
    Ok(Value::Node(
        node.next_shape(cleaned(result, args.flag("clean")?)?),
    ))
}

/// `clean()`.
pub(super) fn clean(args: &Args<'_>) -> Result<Value> {
    let node = args.on()?;
    let mut objects = Vec::new();
    for object in &node.objects {
        objects.push(match object.as_shape() {
            Some(shape) => Object::shape(shape.cleaned()?),
            None => object.clone(),
        });
    }
    Ok(Value::Node(node.next(objects)))
}
