//! Planes, tags, selection, and the stack.

use std::rc::Rc;

use assemcad_model::frame::{Frame, Placement};
use assemcad_model::selector::Selector;

use super::args::{Args, frame};
use super::select::{distinct, select};
use super::value::{Node, Object, Value, Vector};
use crate::brep::{Form, Topology};
use crate::error::{KernelError, Result};
use crate::shape::Shape;

/// Smaller than this, in mm or as a sine, is nothing: CadQuery's.
const TOLERANCE: f64 = 1e-4;

/// A plane from its origin and directions, x brought square to the normal.
pub(super) fn plane(origin: Vector, x: Vector, normal: Vector) -> Result<Placement> {
    let z = normal.normalize();
    let x = x - z * z.dot(&x);
    Frame::new(origin.into(), z.into(), x.into())
        .and_then(|frame| frame.placement())
        .map_err(|e| KernelError::refused(format!("the workplane cannot be set: {e}")))
}

/// The planes that have names, by x and z.
fn named(name: &str) -> Option<([f64; 3], [f64; 3])> {
    Some(match name {
        "XY" | "front" => ([1.0, 0.0, 0.0], [0.0, 0.0, 1.0]),
        "YZ" => ([0.0, 1.0, 0.0], [1.0, 0.0, 0.0]),
        "ZX" => ([0.0, 0.0, 1.0], [0.0, 1.0, 0.0]),
        "XZ" => ([1.0, 0.0, 0.0], [0.0, -1.0, 0.0]),
        "YX" => ([0.0, 1.0, 0.0], [0.0, 0.0, -1.0]),
        "ZY" => ([0.0, 0.0, 1.0], [-1.0, 0.0, 0.0]),
        "back" => ([-1.0, 0.0, 0.0], [0.0, 0.0, -1.0]),
        "left" => ([0.0, 0.0, 1.0], [-1.0, 0.0, 0.0]),
        "right" => ([0.0, 0.0, -1.0], [1.0, 0.0, 0.0]),
        "top" => ([1.0, 0.0, 0.0], [0.0, 1.0, 0.0]),
        "bottom" => ([1.0, 0.0, 0.0], [0.0, -1.0, 0.0]),
        _ => return None,
    })
}

/// The plane of a name.
pub(super) fn named_plane(word: &str, origin: Vector) -> Result<Placement> {
    let (x, z) = named(word).ok_or_else(|| {
        KernelError::refused(format!(
            "there is no plane '{}': they are XY, YZ, ZX, XZ, YX, ZY, front, back, left, right, top \
             and bottom",
            assemcad_model::param::clip(word)
        ))
    })?;
    plane(origin, x.into(), z.into())
}

/// `Workplane(inPlane, origin, obj)`.
pub(super) fn begin(args: &Args<'_>) -> Result<Value> {
    let origin = args.vector("origin")?;
    let on_plane = args.json("inPlane");
    let (at, mut objects) = if let Some(word) = on_plane.and_then(|json| json.as_str()) {
        (named_plane(word, origin)?, Vec::new())
    } else if let Some(at) = on_plane.and_then(frame) {
        (at, Vec::new())
    } else {
        // A shape, or a place given to a function of eachpoint, stands on the stack of XY.
        let objects = match args
            .reference("inPlane")
            .map(|at| args.value(at))
            .transpose()?
        {
            Some(Value::Place(place)) => {
                return Ok(Value::Node(Node::begin(*place, Vec::new())));
            }
            _ => args.objects("inPlane")?,
        };
        let at = Placement::translation(origin.x, origin.y, origin.z);
        (at, objects)
    };
    if args.given("obj") {
        objects = args.objects("obj")?;
    }
    Ok(Value::Node(Node::begin(at, objects)))
}

/// Where `workplane()` puts its plane on one or more objects.
struct Seat {
    center: Vector,
    normal: Vector,
    x: Vector,
}

/// x for a plane of this normal: level, and along the world's x where the plane itself is level.
pub(super) fn level_x(normal: &Vector) -> Vector {
    let x = Vector::z().cross(normal);
    if x.norm() < TOLERANCE { Vector::x() } else { x }
}

fn seat(node: &Node, by_box: bool) -> Result<Seat> {
    if node.objects.len() > 1 {
        let mut faces: Vec<&Shape> = Vec::new();
        for object in &node.objects {
            match object.of(Topology::Face)? {
                Some(face) if face.form()? == Form::Plane => faces.push(face),
                _ => {
                    return Err(KernelError::refused(
                        "a workplane on several objects needs plane faces: select one object, or \
                         faces of one plane",
                    ));
                }
            }
        }
        let Some((first, rest)) = faces.split_first() else {
            return Err(KernelError::internal("several objects and none of them"));
        };
        let (point, normal) = (
            Vector::from(first.center()?),
            Vector::from(first.normal_at(None)?),
        );
        for other in rest {
            let (p, n) = (
                Vector::from(other.center()?),
                Vector::from(other.normal_at(None)?),
            );
            let across = normal.dot(&(point - p)).abs();
            if across >= TOLERANCE || (n - normal).norm() >= TOLERANCE {
                return Err(KernelError::refused(format!(
                    "the selected faces do not lie in one plane: two of them are {across:.6} mm \
                     apart along the normal of the first"
                )));
            }
        }
        let center = if by_box {
            Shape::compound(&faces)?.box_center()?
        } else {
            Shape::combined_center(&faces)?
        };
        return Ok(Seat {
            center: center.into(),
            normal,
            x: level_x(&normal),
        });
    }
    let object = node.first();
    if let Some(face) = object.of(Topology::Face)? {
        let center = if by_box {
            face.box_center()?
        } else {
            face.center()?
        };
        let normal = Vector::from(face.normal_at(Some(center))?);
        return Ok(Seat {
            center: center.into(),
            normal,
            x: level_x(&normal),
        });
    }
    let center = match &object {
        Object::Point(point) => *point,
        Object::Shape(body) if by_box => body.box_center()?.into(),
        Object::Shape(body) => body.center()?.into(),
        Object::Place(_) => {
            return Err(KernelError::refused(
                "a workplane needs a face, a vertex or a point, and the stack holds a location",
            ));
        }
    };
    // A vertex of a selected face: the face says the direction.
    let before = node.parent.as_ref().map(|parent| parent.first());
    if let Some(face) = before
        .as_ref()
        .map(|b| b.of(Topology::Face))
        .transpose()?
        .flatten()
    {
        let normal = Vector::from(face.normal_at(Some(center.into()))?);
        return Ok(Seat {
            center,
            normal,
            x: level_x(&normal),
        });
    }
    let [x, _, z] = node.plane.axes();
    Ok(Seat {
        center,
        normal: z,
        x,
    })
}

/// `workplane(offset, invert, centerOption, origin)`.
pub(super) fn workplane(args: &Args<'_>) -> Result<Value> {
    let node = args.on()?;
    let option = args.text("centerOption")?;
    let Seat {
        mut center,
        mut normal,
        x,
    } = seat(&node, option == "CenterOfBoundBox")?;
    normal = normal.normalize();
    if option == "ProjectedOrigin" {
        let origin = args
            .vector_or_none("origin")?
            .unwrap_or_else(|| node.origin());
        center = origin - normal * (origin - center).dot(&normal);
    }
    if args.flag("invert")? {
        normal = -normal;
    }
    let at = plane(center + normal * args.real("offset")?, x, normal)?;
    Ok(Value::Node(node.next_on(at, Vec::new())))
}

/// `transformed(rotate, offset)`: turned about the plane's own x, y and z, in this order of writing.
pub(super) fn transformed(args: &Args<'_>) -> Result<Value> {
    let node = args.on()?;
    let (rotate, offset) = (args.vector("rotate")?, args.vector("offset")?);
    let [x, y, z] = node.plane.axes();
    let about = |axis: Vector, deg: f64| {
        Placement::rotation_about([0.0; 3], axis.into(), deg)
            .map_err(|e| KernelError::refused(e.to_string()))
    };
    let turn = about(x, rotate.x)? * about(y, rotate.y)? * about(z, rotate.z)?;
    let at = plane(
        node.to_world(offset),
        turn.direction(x.into()).into(),
        turn.direction(z.into()).into(),
    )?;
    let origin = Object::Point(at.origin());
    Ok(Value::Node(node.next_on(at, vec![origin])))
}

/// `center(x, y)`.
pub(super) fn center(args: &Args<'_>) -> Result<Value> {
    let node = args.on()?;
    let by = Placement::translation(args.real("x")?, args.real("y")?, 0.0);
    let at = node.plane * by;
    Ok(Value::Node(
        node.next_on(at, vec![Object::Point(at.origin())]),
    ))
}

/// `copyWorkplane(obj)`: the other's plane and stack, in this chain.
pub(super) fn copy_workplane(args: &Args<'_>) -> Result<Value> {
    let node = args.on()?;
    let other = args
        .node("obj")?
        .ok_or_else(|| KernelError::refused("copyWorkplane takes a workplane"))?;
    Ok(Value::Node(
        node.next_on(other.plane, other.objects.clone()),
    ))
}

fn tagged(node: &Node, name: &str) -> Result<Rc<Node>> {
    let context = node.context.borrow();
    context.tags.get(name).cloned().ok_or_else(|| {
        let names: Vec<&str> = context.tags.keys().map(String::as_str).collect();
        KernelError::refused(format!(
            "there is no tag '{}' in this chain; its tags are [{}]",
            assemcad_model::param::clip(name),
            names.join(", ")
        ))
    })
}

pub(super) fn workplane_from_tagged(args: &Args<'_>) -> Result<Value> {
    let node = args.on()?;
    let other = tagged(&node, args.text("name")?)?;
    Ok(Value::Node(
        node.next_on(other.plane, other.objects.clone()),
    ))
}

pub(super) fn tag(args: &Args<'_>) -> Result<Value> {
    let node = args.on()?;
    let name = args.text("name")?.to_owned();
    // The tag points at a link with a context of its own: the chain's context would hold itself.
    let copy = Node::begin(node.plane, node.objects.clone());
    node.context.borrow_mut().tags.insert(name, copy);
    Ok(Value::Node(node))
}

pub(super) fn end(args: &Args<'_>) -> Result<Value> {
    let mut node = args.on()?;
    for step in 0..args.count("n")? {
        let parent = node.parent.clone().ok_or_else(|| {
            KernelError::refused(format!("the chain has only {step} links before this one"))
        })?;
        node = parent;
    }
    Ok(Value::Node(node))
}

/// `first()`, `last()`, `item(i)`.
pub(super) fn item(args: &Args<'_>, index: Index) -> Result<Value> {
    let node = args.on()?;
    let count = node.objects.len();
    let place = match index {
        Index::First => Some(0),
        Index::Last => count.checked_sub(1),
        Index::At(i) if i < 0 => {
            count.checked_sub(usize::try_from(i.unsigned_abs()).unwrap_or(usize::MAX))
        }
        Index::At(i) => usize::try_from(i).ok(),
    };
    match place.and_then(|place| node.objects.get(place)) {
        Some(object) => Ok(Value::Node(node.next(vec![object.clone()]))),
        None => Err(KernelError::refused(format!(
            "the stack holds {count} objects, and the one asked for is not among them"
        ))),
    }
}

/// Which object of the stack.
pub(super) enum Index {
    First,
    Last,
    At(i32),
}

pub(super) fn add(args: &Args<'_>) -> Result<Value> {
    let node = args.on()?;
    let mut objects = node.objects.clone();
    objects.extend(args.objects("obj")?);
    if let Some(other) = args.node("obj")? {
        merge_tags(&node, &other);
    }
    Ok(Value::Node(node.next(objects)))
}

/// Tags of another chain that this one has not.
pub(super) fn merge_tags(node: &Node, other: &Node) {
    if Rc::ptr_eq(&node.context, &other.context) {
        return;
    }
    let more = other.context.borrow().tags.clone();
    let mut context = node.context.borrow_mut();
    for (name, tagged) in more {
        context.tags.entry(name).or_insert(tagged);
    }
}

/// `faces(selector, tag)` and its like.
pub(super) fn choose(args: &Args<'_>, kind: Topology) -> Result<Value> {
    let node = args.on()?;
    let from = match args.text_or_none("tag")? {
        Some(name) => tagged(&node, name)?,
        None => Rc::clone(&node),
    };
    let all = parts(&from, kind)?;
    let found = match args.read::<Selector>("selector")? {
        Some(selector) => select(&selector, &all)?,
        None => all,
    };
    Ok(Value::Node(node.next(bodies(found))))
}

/// The sub-shapes of a kind of everything on the stack, each once.
pub(super) fn parts(node: &Node, kind: Topology) -> Result<Vec<Rc<Shape>>> {
    let mut all = Vec::new();
    for shape in node.shapes() {
        for part in shape.parts(kind)? {
            all.push(Rc::new(part));
        }
    }
    // Parts of one shape are distinct already.
    if node.objects.len() > 1 {
        all = distinct(all);
    }
    Ok(all)
}

pub(super) fn bodies(shapes: impl IntoIterator<Item = Rc<Shape>>) -> Vec<Object> {
    shapes.into_iter().map(Object::Shape).collect()
}

fn kind_named(word: &str) -> Result<Topology> {
    Ok(match word {
        "Vertex" => Topology::Vertex,
        "Edge" => Topology::Edge,
        "Wire" => Topology::Wire,
        "Face" => Topology::Face,
        "Shell" => Topology::Shell,
        "Solid" => Topology::Solid,
        "CompSolid" => Topology::CompSolid,
        "Compound" => Topology::Compound,
        _ => return Err(KernelError::refused("there is no such kind of shape")),
    })
}

fn stack_of(args: &Args<'_>, node: &Rc<Node>) -> Result<Vec<Rc<Shape>>> {
    let from = match args.text_or_none("tag")? {
        Some(name) => tagged(node, name)?,
        None => Rc::clone(node),
    };
    Ok(from.shapes().cloned().collect())
}

/// `ancestors(kind)`: what of the chain's solid holds the objects.
pub(super) fn ancestors(args: &Args<'_>) -> Result<Value> {
    let node = args.on()?;
    let (solid, kind) = (node.solid()?, kind_named(args.text("kind")?)?);
    let mut found = Vec::new();
    for shape in stack_of(args, &node)? {
        found.extend(solid.ancestors(&shape, kind)?.into_iter().map(Rc::new));
    }
    Ok(Value::Node(node.next(bodies(distinct(found)))))
}

/// `siblings(kind, level)`: what shares a border of a kind with the objects, `level` steps away.
pub(super) fn siblings(args: &Args<'_>) -> Result<Value> {
    let node = args.on()?;
    let (solid, kind) = (node.solid()?, kind_named(args.text("kind")?)?);
    let stack = stack_of(args, &node)?;
    let mut all = Vec::new();
    for shape in &stack {
        let own = shape.topology()?;
        let mut seen = vec![Rc::clone(shape)];
        let mut ring = vec![Rc::clone(shape)];
        for _ in 0..args.count("level")?.max(1) {
            let mut next = Vec::new();
            for member in &ring {
                for border in member.parts(kind)? {
                    next.extend(solid.ancestors(&border, own)?.into_iter().map(Rc::new));
                }
            }
            ring = distinct(next)
                .into_iter()
                .filter(|s| !seen.iter().any(|known| known.same(s)))
                .collect();
            if ring.is_empty() {
                break;
            }
            seen.extend(ring.iter().cloned());
        }
        all.extend(ring);
    }
    let found = distinct(all)
        .into_iter()
        .filter(|s| !stack.iter().any(|known| known.same(s)));
    Ok(Value::Node(node.next(bodies(found))))
}
