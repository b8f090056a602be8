//! Calls that make geometry and its port in one.
//!
//! What a port states is measured on the solid, wherever the script did not say it: a through hole's
//! depth, a face's extents. What cannot be measured is refused here and not found out later.

use std::collections::BTreeMap;
use std::rc::Rc;

use assemcad_model::frame::Placement;
use assemcad_model::language::Outline;
use assemcad_model::name;
use assemcad_model::param::clip;
use assemcad_model::ports::{self, Port, PortType};

use super::args::Args;
use super::combine::safe_union;
use super::draw::outline_wire;
use super::each::{copies, world_places};
use super::face::{Extents, face_at, measure};
use super::transform::tidy;
use super::value::{Node, Value};
use crate::error::{KernelError, Result};
use crate::shape::Shape;

pub(super) type Params = BTreeMap<String, f64>;

pub(super) fn params<const N: usize>(pairs: [(&str, f64); N]) -> Params {
    pairs
        .into_iter()
        .map(|(name, value)| (name.to_owned(), value))
        .collect()
}

/// A port at a place of the world.
pub(super) fn port(
    name: &str,
    port_type: PortType,
    at: &Placement,
    params: Params,
) -> Result<Port> {
    if !name::is_valid(name) {
        return Err(KernelError::refused(format!(
            "'{}' is no name for a port: {}",
            clip(name),
            name::RULE
        )));
    }
    let port = Port {
        name: name.to_owned(),
        port_type,
        frame: tidy(at)?,
        params: params
            .into_iter()
            // The last digits of what was measured are the kernel's and not the part's.
            .map(|(name, value)| (name, (value * 1e9).round() / 1e9 + 0.0))
            .collect(),
    };
    match port.faults().as_slice() {
        [] => Ok(port),
        faults => Err(KernelError::refused(format!(
            "port '{name}': {}",
            faults.join("; ")
        ))),
    }
}

/// The link with more ports.
pub(super) fn with(node: &Rc<Node>, more: Vec<Port>) -> Result<Value> {
    let mut all = node.ports.as_ref().clone();
    for port in more {
        if all.iter().any(|known| known.name == port.name) {
            return Err(KernelError::refused(format!(
                "there are two ports '{}' in this part: give one another name",
                port.name
            )));
        }
        all.push(port);
    }
    Ok(Value::Node(node.with_ports(all)))
}

/// `NAME` for one, `NAME_1`, `NAME_2` and so on for several.
pub(super) fn numbered(name: &str, count: usize, index: usize) -> String {
    if count == 1 {
        name.to_owned()
    } else {
        format!("{name}_{}", index + 1)
    }
}

/// The FLAT_FACE port in the middle of a pattern: the largest square about it on the face.
pub(super) fn pattern_center(node: &Node, name: &str, at: &[Placement]) -> Result<Port> {
    let count = u32::try_from(at.len()).map_or(1.0, f64::from);
    let sum = at
        .iter()
        .map(Placement::origin)
        .sum::<super::value::Vector>();
    let [x, _, z] = node.plane.axes();
    let here = super::chain::plane(sum / count, x, z)?;
    for place in at {
        let [_, _, normal] = place.axes();
        if (normal - z).norm() > 1e-6 {
            return Err(KernelError::refused(
                "the places look into different directions: a pattern has a center in one plane only",
            ));
        }
    }
    let solid = node.solid()?;
    let face = face_at(&solid, &here)?;
    flat(name, &here, measure(&face, &here)?)
}

fn flat(name: &str, at: &Placement, extents: Extents) -> Result<Port> {
    let Extents { x, y, hole } = extents;
    let mut found = params([("extent_x", x), ("extent_y", y)]);
    if hole > 0.0 {
        found.insert("hole_diameter".to_owned(), hole);
    }
    port(name, PortType::FlatFace, at, found)
}

/// What is made at each place, joined to the chain's solid where there is one.
fn grown(args: &Args<'_>, made: &Shape, ports: Vec<Port>) -> Result<Value> {
    let node = args.on()?;
    let mut tools = copies(&node, made)?;
    let joined = match node.find_solid()? {
        Some(base) => safe_union(&base, &tools, false, None)?.cleaned()?,
        None if tools.len() == 1 => tools.remove(0),
        None => Shape::compound(&tools.iter().collect::<Vec<&Shape>>())?,
    };
    with(&node.next_shape(joined), ports)
}

/// The same port at every place, `shift` away from it.
fn at_places(
    args: &Args<'_>,
    shift: &Placement,
    port_type: PortType,
    found: &Params,
) -> Result<Vec<Port>> {
    let places = world_places(&*args.on()?)?;
    let base = args.text("name")?;
    places
        .iter()
        .enumerate()
        .map(|(index, place)| {
            let name = numbered(base, places.len(), index);
            port(&name, port_type, &(*place * *shift), found.clone())
        })
        .collect()
}

/// `shaft_port(name, diameter, length, center)`.
pub(super) fn shaft(args: &Args<'_>) -> Result<Value> {
    let (diameter, length) = (args.length("diameter")?, args.length("length")?);
    let made = Shape::cylinder_part(&Placement::IDENTITY, diameter / 2.0, length, 360.0)?;
    let found = params([("diameter", diameter), ("length", length)]);
    let middle = Placement::translation(0.0, 0.0, length / 2.0);
    let ports = at_places(args, &middle, PortType::Shaft, &found)?;
    let Value::Node(next) = grown(args, &made, ports)? else {
        return Err(KernelError::internal("shafts are no workplane"));
    };
    let Some(center) = args.text_or_none("center")? else {
        return Ok(Value::Node(next));
    };
    let at = world_places(&*args.on()?)?;
    let middle = pattern_center(&next, center, &at)?;
    with(&next, vec![middle])
}

/// `gear_mesh_port(name, module, teeth, width, ...)`; the outline was computed by the front end.
pub(super) fn gear(args: &Args<'_>) -> Result<Value> {
    let outline = args
        .read::<Outline>("outline")?
        .ok_or_else(|| KernelError::refused("the gear has no outline"))?;
    let width = args.length("width")?;
    let wire = outline_wire(&outline)?;
    let made = Shape::face(&wire, &[])?.extruded([0.0, 0.0, width], 0.0)?;
    let found = params([
        ("module", args.real("module")?),
        ("teeth", f64::from(args.count("teeth")?)),
        ("pressure_angle_deg", args.real("pressure_angle_deg")?),
        ("helix_angle_deg", 0.0),
        ("width", width),
        ("internal", 0.0),
        ("profile_shift", args.real("profile_shift")?),
        ("thinning", args.real("thinning")?),
    ]);
    let middle = Placement::translation(0.0, 0.0, width / 2.0);
    let ports = at_places(args, &middle, PortType::GearMesh, &found)?;
    grown(args, &made, ports)
}

/// `snap_port(name, overlap, width, length, thickness, lead_angle_deg)`: a beam about the plane's z,
/// its nose along x, the locking face looking back at the plane.
pub(super) fn snap(args: &Args<'_>) -> Result<Value> {
    let (overlap, width) = (args.length("overlap")?, args.length("width")?);
    let (length, thickness) = (args.length("length")?, args.length("thickness")?);
    let lead = args.real("lead_angle_deg")?;
    if !(lead > 0.0 && lead < 90.0) {
        return Err(KernelError::refused(format!(
            "lead_angle_deg is over 0 and below 90, not {lead}"
        )));
    }
    let (sin, cos) = assemcad_model::angle::sin_cos_deg(lead);
    let nose = overlap * cos / sin;
    if nose >= length {
        return Err(KernelError::refused(format!(
            "the hook's nose takes {nose:.3} mm of its length {length} mm: make lead_angle_deg or \
             length larger"
        )));
    }
    let (half, lock) = (thickness / 2.0, length - nose);
    let at = |x: f64, z: f64| [x, -width / 2.0, z];
    let outline = [
        at(-half, 0.0),
        at(half, 0.0),
        at(half, lock),
        at(half + overlap, lock),
        at(half, length),
        at(-half, length),
    ];
    let wire = Shape::polyline_wire(&outline, true)?;
    let made = Shape::face(&wire, &[])?.extruded([0.0, width, 0.0], 0.0)?;
    let found = params([("overlap", overlap), ("width", width)]);
    let locking =
        Placement::translation(half + overlap / 2.0, 0.0, lock) * Placement::rotation_x(180.0);
    let ports = at_places(args, &locking, PortType::SnapFit, &found)?;
    grown(args, &made, ports)
}

/// `face_port(name, extent_x, extent_y, hole_diameter, at)`.
pub(super) fn face(args: &Args<'_>) -> Result<Value> {
    let node = args.on()?;
    let (x, y) = (
        args.real_or_none("extent_x")?,
        args.real_or_none("extent_y")?,
    );
    let at = if args.given("at") {
        plane_argument(args)?
    } else {
        super::face::seat(&node)?
    };
    let extents = match (x, y) {
        (Some(x), Some(y)) => Extents {
            x,
            y,
            hole: args.real_or_none("hole_diameter")?.unwrap_or(0.0),
        },
        _ => {
            let face = face_at(&node.solid()?, &at)?;
            let found = measure(&face, &at)?;
            Extents {
                x: x.unwrap_or(found.x),
                y: y.unwrap_or(found.y),
                hole: args.real_or_none("hole_diameter")?.unwrap_or(found.hole),
            }
        }
    };
    with(&node, vec![flat(args.text("name")?, &at, extents)?])
}

fn plane_argument(args: &Args<'_>) -> Result<Placement> {
    match args.json("at") {
        Some(serde_json::Value::String(word)) => {
            super::chain::named_plane(word, super::value::Vector::zeros())
        }
        Some(json) => super::args::frame(json)
            .ok_or_else(|| KernelError::refused("at is a plane: cq.Plane(origin, xDir, normal)")),
        None => Err(KernelError::internal("there is no plane")),
    }
}

/// `port(name, type, params, at)`: at the points of the stack, or at a plane.
pub(super) fn plain(args: &Args<'_>) -> Result<Value> {
    let node = args.on()?;
    let word = args.text("type")?;
    let kind = ports::ALL
        .iter()
        .find(|kind| kind.name == word)
        .ok_or_else(|| {
            let names: Vec<&str> = ports::ALL.iter().map(|kind| kind.name).collect();
            KernelError::refused(format!(
                "there is no port type '{}': they are {}",
                clip(word),
                names.join(", ")
            ))
        })?;
    let found: Params = args.read("params")?.unwrap_or_default();
    if args.given("at") {
        let at = plane_argument(args)?;
        let one = port(args.text("name")?, kind.port_type, &at, found)?;
        return with(&node, vec![one]);
    }
    let ports = at_places(args, &Placement::IDENTITY, kind.port_type, &found)?;
    with(&node, ports)
}

/// `with_ports_of(other, prefix)`.
pub(super) fn of_other(args: &Args<'_>) -> Result<Value> {
    let node = args.on()?;
    let other = args
        .node("other")?
        .ok_or_else(|| KernelError::refused("with_ports_of takes a workplane"))?;
    let prefix = args.text_or_none("prefix")?.unwrap_or_default();
    let more = other
        .ports
        .iter()
        .map(|port| Port {
            name: format!("{prefix}{}", port.name),
            ..port.clone()
        })
        .collect();
    with(&node, more)
}
