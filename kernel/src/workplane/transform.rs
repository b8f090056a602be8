//! Rigid motions and mirror images, of shapes and of the ports on them.

use assemcad_model::frame::{Frame, Placement};
use assemcad_model::ports::Port;

use super::args::Args;
use super::combine::safe_union;
use super::value::{Object, Value, Vector};
use crate::brep::Topology;
use crate::error::{KernelError, Result};
use crate::shape::Shape;

pub(super) fn translation(by: Vector) -> Placement {
    Placement::translation(by.x, by.y, by.z)
}

pub(super) fn rotation(from: Vector, to: Vector, angle: f64) -> Result<Placement> {
    let axis = to - from;
    if axis.norm() == 0.0 {
        return Err(KernelError::refused(
            "the axis ends where it begins: give two different points",
        ));
    }
    Placement::rotation_about(from.into(), axis.into(), angle)
        .map_err(|e| KernelError::refused(e.to_string()))
}

/// The stack moved, and the ports with it.
fn moved(args: &Args<'_>, by: &Placement) -> Result<Value> {
    let node = args.on()?;
    let mut objects = Vec::new();
    for object in &node.objects {
        objects.push(match object.as_shape() {
            // Written anew: the result is measured and cut as if it had been made there.
            Some(shape) => Object::shape(shape.moved(by)?.baked()?),
            None => object.clone(),
        });
    }
    let ports = node
        .ports
        .iter()
        .map(|port| Port {
            frame: by.frame(&port.frame),
            ..port.clone()
        })
        .collect();
    Ok(Value::Node(node.next(objects).with_ports(ports)))
}

/// `translate(vec)`.
pub(super) fn translate(args: &Args<'_>) -> Result<Value> {
    moved(args, &translation(args.vector("vec")?))
}

/// `rotate(axisStartPoint, axisEndPoint, angleDegrees)`.
pub(super) fn rotate(args: &Args<'_>) -> Result<Value> {
    let by = rotation(
        args.vector("axisStartPoint")?,
        args.vector("axisEndPoint")?,
        args.real("angleDegrees")?,
    )?;
    moved(args, &by)
}

/// `rotateAboutCenter(axisEndPoint, angleDegrees)`: about a direction through each object's centre.
pub(super) fn rotate_about_center(args: &Args<'_>) -> Result<Value> {
    let node = args.on()?;
    let (direction, angle) = (args.vector("axisEndPoint")?, args.real("angleDegrees")?);
    let shapes: Vec<_> = node.shapes().collect();
    if let [one] = shapes.as_slice() {
        let center = Vector::from(one.center()?);
        return moved(args, &rotation(center, center + direction, angle)?);
    }
    let mut objects = Vec::new();
    for shape in shapes {
        let center = Vector::from(shape.center()?);
        let by = rotation(center, center + direction, angle)?;
        objects.push(Object::shape(shape.moved(&by)?.baked()?));
    }
    // Each object turns on its own: where the ports go cannot be said.
    Ok(Value::Node(node.next(objects).with_ports(Vec::new())))
}

/// A mirror plane: a point of it and its normal.
pub(super) fn mirror_plane(args: &Args<'_>) -> Result<(Option<Vector>, Vector)> {
    let json = args.json("mirrorPlane");
    if let Some(word) = json.and_then(|json| json.as_str()) {
        let normal = match word {
            "XY" | "YX" => Vector::z(),
            "XZ" | "ZX" => Vector::y(),
            "YZ" | "ZY" => Vector::x(),
            _ => {
                return Err(KernelError::refused(
                    "a mirror plane is XY, XZ, YZ, a normal or a face",
                ));
            }
        };
        return Ok((None, normal));
    }
    if let Some(normal) = json.and_then(super::args::vector) {
        return Ok((None, normal));
    }
    for object in args.objects("mirrorPlane")? {
        if let Some(face) = object.of(Topology::Face)? {
            return Ok((Some(face.center()?.into()), face.normal_at(None)?.into()));
        }
    }
    Err(KernelError::refused(
        "a mirror plane is XY, XZ, YZ, a normal or a face, and no face is on that stack",
    ))
}

/// `mirror(mirrorPlane, basePointVector, union)`.
pub(super) fn mirror(args: &Args<'_>) -> Result<Value> {
    let node = args.on()?;
    let (on_face, normal) = mirror_plane(args)?;
    if normal.norm() == 0.0 {
        return Err(KernelError::refused(
            "the mirror plane's normal has no length",
        ));
    }
    let point = args
        .vector_or_none("basePointVector")?
        .or(on_face)
        .unwrap_or_default();
    let mut images = Vec::new();
    for shape in node.shapes() {
        images.push(shape.mirrored(point.into(), normal.into())?);
    }
    if !args.flag("union")? {
        let ports = node
            .ports
            .iter()
            .map(|port| mirrored(port, point, normal.normalize()))
            .collect();
        let objects = images.into_iter().map(Object::shape).collect();
        return Ok(Value::Node(node.next(objects).with_ports(ports)));
    }
    let mut others = Vec::new();
    for image in &images {
        others.extend(image.parts(Topology::Solid)?);
    }
    let joined = safe_union(&node.solid()?, &others, false, None)?;
    Ok(Value::Node(node.next_shape(joined.cleaned()?)))
}

/// A port's mirror image. Its frame stays right-handed: origin, z and x are mirrored. A helix of teeth
/// turns the other way; a thread keeps its hand, because it is tapped and not mirrored.
fn mirrored(port: &Port, point: Vector, n: Vector) -> Port {
    let turn = |v: [f64; 3]| -> [f64; 3] {
        let v = Vector::from(v);
        (v - n * (2.0 * n.dot(&v))).into()
    };
    let from_point: [f64; 3] = (Vector::from(port.frame.origin) - point).into();
    let origin = Vector::from(turn(from_point)) + point;
    let mut params = port.params.clone();
    if let Some(helix) = params.get_mut("helix_angle_deg") {
        *helix = 0.0 - *helix;
    }
    Port {
        params,
        frame: Frame {
            origin: origin.into(),
            x: turn(port.frame.x),
            z: turn(port.frame.z),
        },
        ..port.clone()
    }
}

/// A frame whose last digits do not show where the kernel found it: lengths to 1e-9 mm, directions
/// exact where they are within 1e-12 of an axis.
pub(super) fn tidy(at: &Placement) -> Result<Frame> {
    let [x, _, z] = at.axes();
    let length = |n: f64| (n * 1e9).round() / 1e9 + 0.0;
    let share = |n: f64| {
        let whole = n.round();
        if (n - whole).abs() < 1e-12 {
            whole + 0.0
        } else {
            n
        }
    };
    Frame::new(
        at.origin().map(length).into(),
        z.map(share).into(),
        x.map(share).into(),
    )
    .map_err(|e| KernelError::refused(format!("the port's frame: {e}")))
}

/// A node's ports moved along with a shape are the business of `moved`; a shape alone has none.
pub(super) fn moved_object(object: &Object, by: &Placement) -> Result<Object> {
    match object {
        Object::Shape(body) => Ok(Object::shape(body.moved(by)?.baked()?)),
        Object::Point(point) => Ok(Object::Point(by.point((*point).into()).into())),
        Object::Place(place) => Ok(Object::Place(*by * *place)),
    }
}

/// The one shape of an object.
pub(super) fn body(object: &Object) -> Result<&Shape> {
    object.as_shape().map(AsRef::as_ref).ok_or_else(|| {
        KernelError::refused(format!("a shape is needed, not {}", object.describe()))
    })
}
