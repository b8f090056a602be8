//! Points, patterns of them, and what is made at each.

use std::rc::Rc;

use assemcad_model::angle::sin_cos_deg;
use assemcad_model::frame::{Frame, Placement};

use super::args::{Args, vector};
use super::combine::joined;
use super::value::{Node, Object, Value, Vector};
use crate::brep::Topology;
use crate::error::{KernelError, Result};
use crate::shape::Shape;

/// Most points of one pattern.
const MOST_POINTS: usize = 10_000;

/// The places of the stack in the workplane's own coordinates; its origin where the stack is empty.
pub(super) fn places(node: &Node) -> Result<Vec<Placement>> {
    if node.objects.is_empty() {
        return Ok(vec![Placement::IDENTITY]);
    }
    node.objects
        .iter()
        .map(|object| {
            let world = match object {
                Object::Place(place) => return Ok(*place),
                Object::Point(point) => *point,
                Object::Shape(body) => body.center()?.into(),
            };
            let local = node.to_local(world);
            Ok(Placement::translation(local.x, local.y, local.z))
        })
        .collect()
}

/// The same in the world.
pub(super) fn world_places(node: &Node) -> Result<Vec<Placement>> {
    let local = places(node)?;
    Ok(local.into_iter().map(|place| node.plane * place).collect())
}

/// A solid at each place.
pub(super) fn copies(node: &Node, solid: &Shape) -> Result<Vec<Shape>> {
    world_places(node)?
        .iter()
        // Written anew: where a boolean meets a solid that has a location, its edges are there in two
        // spellings afterwards, and the boundary no longer hangs together once locations are taken off.
        .map(|at| solid.moved(at)?.baked())
        .collect()
}

/// A wire at each place, drawn unless it is for construction.
pub(super) fn at_each_place(node: &Rc<Node>, wire: &Shape, construction: bool) -> Result<Rc<Node>> {
    let mut objects = Vec::new();
    for place in places(node)? {
        let shape = Rc::new(wire.moved(&(node.plane * place))?.baked()?);
        if !construction {
            node.context.borrow_mut().wires.push(Rc::clone(&shape));
        }
        objects.push(Object::Shape(shape));
    }
    Ok(node.next(objects))
}

/// `pushPoints(points)`.
pub(super) fn push_points(args: &Args<'_>) -> Result<Value> {
    let node = args.on()?;
    let listed = args
        .json("pntList")
        .and_then(|json| json.as_array())
        .ok_or_else(|| KernelError::refused("pushPoints takes a list of points"))?;
    let mut objects = Vec::new();
    for item in listed {
        objects.push(match vector(item) {
            Some(point) => Object::Point(node.to_world(point)),
            None => Object::Place(args.place_of("pntList", item)?),
        });
    }
    Ok(Value::Node(node.next(objects)))
}

fn counted(name: &str, count: i32) -> Result<usize> {
    usize::try_from(count)
        .ok()
        .filter(|n| (1..=MOST_POINTS).contains(n))
        .ok_or_else(|| KernelError::refused(format!("{name} is 1 to {MOST_POINTS}, not {count}")))
}

/// `rarray(xSpacing, ySpacing, xCount, yCount, center)`.
pub(super) fn rarray(args: &Args<'_>) -> Result<Value> {
    let node = args.on()?;
    let (dx, dy) = (args.real("xSpacing")?, args.real("ySpacing")?);
    let (nx, ny) = (args.count("xCount")?, args.count("yCount")?);
    if counted("xCount", nx)?.saturating_mul(counted("yCount", ny)?) > MOST_POINTS {
        return Err(KernelError::refused(format!(
            "a pattern has at most {MOST_POINTS} points"
        )));
    }
    if dx <= 0.0 && dy <= 0.0 {
        return Err(KernelError::refused(
            "one of xSpacing and ySpacing is over 0",
        ));
    }
    let [cx, cy] = args.flags("center")?;
    let x0 = if cx {
        -dx * f64::from(nx - 1) * 0.5
    } else {
        0.0
    };
    let y0 = if cy {
        -dy * f64::from(ny - 1) * 0.5
    } else {
        0.0
    };
    let mut objects = Vec::new();
    for i in 0..nx {
        for j in 0..ny {
            let local = Vector::new(x0 + dx * f64::from(i), y0 + dy * f64::from(j), 0.0);
            objects.push(Object::Point(node.to_world(local)));
        }
    }
    Ok(Value::Node(node.next(objects)))
}

/// `polarArray(radius, startAngle, angle, count, fill, rotate)`.
pub(super) fn polar_array(args: &Args<'_>) -> Result<Value> {
    let node = args.on()?;
    let (radius, start) = (args.real("radius")?, args.real("startAngle")?);
    let count = args.count("count")?;
    counted("count", count)?;
    let mut step = args.real("angle")?;
    if args.flag("fill")? {
        let turns = step / 360.0;
        // A whole turn has no end of its own: the last point would be the first.
        if (turns - turns.round()).abs() * 360.0 < 1e-6 {
            step /= f64::from(count);
        } else if count > 1 {
            step /= f64::from(count - 1);
        }
    }
    let rotate = args.flag("rotate")?;
    let mut objects = Vec::new();
    for i in 0..count {
        let angle = start + step * f64::from(i);
        let (sin, cos) = sin_cos_deg(angle);
        let shift = Placement::translation(radius * cos, radius * sin, 0.0);
        objects.push(Object::Place(if rotate {
            shift * Placement::rotation_z(angle)
        } else {
            shift
        }));
    }
    Ok(Value::Node(node.next(objects)))
}

/// One solid made at each place.
fn solids(args: &Args<'_>, solid: &Shape) -> Result<Value> {
    let node = args.on()?;
    let made = copies(&node, solid)?;
    joined(args, &node, made)
}

/// `box(length, width, height, centered)`.
pub(super) fn cuboid(args: &Args<'_>) -> Result<Value> {
    let size = [
        args.length("length")?,
        args.length("width")?,
        args.length("height")?,
    ];
    let centered = args.flags::<3>("centered")?;
    let corner: Vec<f64> = size
        .iter()
        .zip(centered)
        .map(|(s, c)| if c { -s / 2.0 } else { 0.0 })
        .collect();
    let origin = corner.try_into().unwrap_or_default();
    let at = Frame {
        origin,
        ..Frame::WORLD
    };
    solids(args, &Shape::cuboid(&at, size)?)
}

/// The frame of a direction: x as the kernel derives it for a plane of this normal.
fn upright(direction: Vector, origin: Vector) -> Result<Placement> {
    if direction.norm() == 0.0 {
        return Err(KernelError::refused("the direction has no length"));
    }
    super::chain::plane(origin, kernel_x(&direction.normalize()), direction)
}

/// The x direction that the kernel gives to an axis of which only z is known (`gp_Ax2`).
pub(super) fn kernel_x(z: &Vector) -> Vector {
    let (a, b, c) = (z.x.abs(), z.y.abs(), z.z.abs());
    if b <= a && b <= c {
        if a > c {
            Vector::new(-z.z, 0.0, z.x)
        } else {
            Vector::new(z.z, 0.0, -z.x)
        }
    } else if a <= b && a <= c {
        if b > c {
            Vector::new(0.0, -z.z, z.y)
        } else {
            Vector::new(0.0, z.z, -z.y)
        }
    } else if a > b {
        Vector::new(-z.y, z.x, 0.0)
    } else {
        Vector::new(z.y, -z.x, 0.0)
    }
}

/// `cylinder(height, radius, direct, angle, centered)`.
pub(super) fn cylinder(args: &Args<'_>) -> Result<Value> {
    let (height, radius) = (args.length("height")?, args.length("radius")?);
    let [cx, cy, cz] = args.flags("centered")?;
    let at = Placement::translation(
        if cx { 0.0 } else { radius },
        if cy { 0.0 } else { radius },
        if cz { -height / 2.0 } else { 0.0 },
    );
    let solid = Shape::cylinder_part(&at, radius, height, args.real("angle")?)?;
    let turn = upright(args.vector("direct")?, Vector::zeros())?;
    solids(args, &solid.moved(&turn)?)
}

/// `sphere(radius, direct, angle1, angle2, angle3, centered)`.
pub(super) fn sphere(args: &Args<'_>) -> Result<Value> {
    let radius = args.length("radius")?;
    let offset = |centered: bool| if centered { 0.0 } else { radius };
    let [cx, cy, cz] = args.flags("centered")?;
    let at = upright(
        args.vector("direct")?,
        Vector::new(offset(cx), offset(cy), offset(cz)),
    )?;
    let solid = Shape::sphere_part(
        &at,
        radius,
        args.real("angle1")?,
        args.real("angle2")?,
        args.real("angle3")?,
    )?;
    solids(args, &solid)
}

/// `wedge(dx, dy, dz, xmin, zmin, xmax, zmax, dir, centered)`.
pub(super) fn wedge(args: &Args<'_>) -> Result<Value> {
    let (dx, dy, dz) = (args.length("dx")?, args.length("dy")?, args.length("dz")?);
    let [cx, cy, cz] = args.flags("centered")?;
    let back = |centered: bool, size: f64| if centered { -size / 2.0 } else { 0.0 };
    let at = upright(
        args.vector("dir")?,
        Vector::new(back(cx, dx), back(cy, dy), back(cz, dz)),
    )?;
    let solid = Shape::wedge(
        &at,
        dx,
        dy,
        dz,
        args.real("xmin")?,
        args.real("zmin")?,
        args.real("xmax")?,
        args.real("zmax")?,
    )?;
    solids(args, &solid)
}

/// What a function or shape gives at each place: `make` is told the place in the world or, where the
/// call works in local coordinates, in the plane.
pub(super) fn each_point(
    args: &Args<'_>,
    mut make: impl FnMut(Option<Placement>) -> Result<Vec<Object>>,
) -> Result<Value> {
    let node = args.on()?;
    let local = args.flag("useLocalCoordinates")?;
    let by_function = args.given("variable");
    let mut made = Vec::new();
    for place in places(&node)? {
        // CadQuery composes the world form this way round, and scripts rely on what comes out.
        let at = if local { place } else { place * node.plane };
        let shapes = make(by_function.then_some(at))?;
        for object in shapes {
            let Object::Shape(body) = object else {
                continue;
            };
            let moved = if by_function {
                body.try_clone()?
            } else {
                body.moved(&at)?
            };
            made.push(if local {
                moved.moved(&node.plane)?.baked()?
            } else {
                moved.baked()?
            });
        }
    }
    finish(args, &node, made)
}

/// What a function gives for each object.
pub(super) fn each_object(
    args: &Args<'_>,
    mut make: impl FnMut(Object) -> Result<Vec<Object>>,
) -> Result<Value> {
    let node = args.on()?;
    if args.flag("useLocalCoordinates")? {
        return Err(KernelError::refused(
            "each works in the world's coordinates here: leave useLocalCoordinates out, or write \
             eachpoint",
        ));
    }
    let objects = if node.objects.is_empty() {
        vec![Object::Point(node.origin())]
    } else {
        node.objects.clone()
    };
    let mut made = Vec::new();
    for object in objects {
        for result in make(object)? {
            if let Object::Shape(body) = result {
                made.push(body.try_clone()?);
            }
        }
    }
    finish(args, &node, made)
}

fn finish(args: &Args<'_>, node: &Rc<Node>, made: Vec<Shape>) -> Result<Value> {
    for shape in &made {
        if shape.topology()? == Topology::Wire {
            node.context
                .borrow_mut()
                .wires
                .push(Rc::new(shape.try_clone()?));
        }
    }
    joined(args, node, made)
}
