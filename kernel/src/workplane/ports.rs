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
use super::combine::{cut, safe_union};
use super::draw::outline_wire;
use super::each::places;
use super::face::{Extents, face_at, measure};
use super::solid::{countersink, drill, through};
use super::transform::tidy;
use super::value::{Node, Value};
use crate::brep::Topology;
use crate::error::{KernelError, Result};
use crate::shape::Shape;

/// How far, in mm, a hole's mouth may be from the workplane, and a measured depth from the stated one.
const NEAR: f64 = 1e-4;

/// D1 = D - 2 * 5/8 * H with H = sqrt(3)/2 * P: the minor diameter of an internal thread (ISO 68-1,
/// ISO 724).
const MINOR: f64 = 1.082_531_754_730_548_3;

type Params = BTreeMap<String, f64>;

fn params<const N: usize>(pairs: [(&str, f64); N]) -> Params {
    pairs
        .into_iter()
        .map(|(name, value)| (name.to_owned(), value))
        .collect()
}

/// A port at a place of the world.
fn port(name: &str, port_type: PortType, at: &Placement, params: Params) -> Result<Port> {
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
fn with(node: &Rc<Node>, more: Vec<Port>) -> Result<Value> {
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
fn numbered(name: &str, count: usize, index: usize) -> String {
    if count == 1 {
        name.to_owned()
    } else {
        format!("{name}_{}", index + 1)
    }
}

/// A piece of a hole: from its mouth to its end, below the workplane.
struct Bore {
    mouth: f64,
    end: f64,
}

/// Where a tool takes material away, by pieces, uppermost first.
fn pieces(solid: &Shape, tool: &Shape, at: &Placement) -> Result<Vec<Bore>> {
    let removed = solid.shared(&[tool], None)?;
    let mut found = Vec::new();
    for piece in removed.parts(Topology::Solid)? {
        let extent = piece.moved(&at.inverse())?.extent()?;
        let ([_, _, low], [_, _, high]) = (extent.min, extent.max);
        found.push(Bore {
            mouth: -high,
            end: -low,
        });
    }
    found.sort_by(|a, b| a.mouth.total_cmp(&b.mouth));
    Ok(found)
}

/// Where holes go, and how deep.
struct Drilled {
    node: Rc<Node>,
    solid: Shape,
    /// The places, in the world.
    at: Vec<Placement>,
    /// How deep the tool goes; through all where none is given.
    depth: f64,
    through: bool,
}

impl Drilled {
    fn of(args: &Args<'_>) -> Result<Self> {
        let node = args.on()?;
        let at = places(&node)?
            .into_iter()
            .map(|place| node.plane * place)
            .collect();
        let (depth, through) = match args.real_or_none("depth")? {
            Some(_) => (args.length("depth")?, false),
            None => (through(&node)?, true),
        };
        Ok(Self {
            solid: node.solid()?,
            node,
            at,
            depth,
            through,
        })
    }

    /// Cuts the tool at every place. For each place: the first piece of the plain hole of `diameter`,
    /// and the last one.
    fn cut(&self, tool: &Shape, diameter: f64) -> Result<(Shape, Vec<(Bore, Bore)>)> {
        let plain = drill(diameter, self.depth)?;
        let (mut tools, mut bores) = (Vec::new(), Vec::new());
        for at in &self.at {
            let mut found = pieces(&self.solid, &plain.moved(at)?, at)?;
            // Rounded here: as text, what is a little below 0 would be -0.000.
            let [x, y, z] = at.origin().map(|n| (n * 1e3).round() / 1e3 + 0.0).into();
            let here = format!("the hole at ({x:.3}, {y:.3}, {z:.3})");
            let Some(last) = found.pop() else {
                let [dx, dy, dz] = at
                    .direction([0.0, 0.0, -1.0])
                    .map(|n| (n * 1e3).round() / 1e3 + 0.0);
                return Err(KernelError::refused(format!(
                    "{here} removes nothing: going {:.3} mm along ({dx:.3}, {dy:.3}, {dz:.3}) it meets \
                     no material; the part spans {} mm. A hole goes against the workplane's normal: \
                     check which way it looks, and where its origin is",
                    self.depth,
                    self.solid.extent()?
                )));
            };
            let first = if found.is_empty() {
                Bore { ..last }
            } else {
                found.remove(0)
            };
            if first.mouth > NEAR {
                return Err(KernelError::refused(format!(
                    "{here} begins {:.4} mm below the workplane: its mouth is not where the port would \
                     be; put the workplane on the face",
                    first.mouth
                )));
            }
            if self.under_material(at)? {
                return Err(KernelError::refused(format!(
                    "{here} begins inside the material: its mouth would be closed; put the workplane \
                     on the face"
                )));
            }
            bores.push((first, last));
            tools.push(tool.moved(at)?.baked()?);
        }
        Ok((cut(&self.solid, &tools, None)?, bores))
    }

    fn under_material(&self, at: &Placement) -> Result<bool> {
        let above = at.point([0.0, 0.0, 10.0 * NEAR]);
        let found = self.solid.classify(&[above], NEAR)?;
        Ok(found.first() == Some(&crate::query::Side::Inside))
    }

    /// The link with the cut solid and the ports.
    fn finish(&self, args: &Args<'_>, cut: Shape, mut ports: Vec<Port>) -> Result<Value> {
        let next = self.node.next_shape(cut.cleaned()?);
        if let Some(center) = args.text_or_none("center")? {
            ports.push(pattern_center(&next, center, &self.at)?);
        }
        with(&next, ports)
    }

    /// The port at the far mouth of a through hole, where one is asked for. Down to `wide` the hole is
    /// wider than its diameter.
    fn back(
        &self,
        args: &Args<'_>,
        index: usize,
        last: &Bore,
        wide: f64,
        make: impl FnOnce(&str, &Placement, f64) -> Result<Port>,
    ) -> Result<Option<Port>> {
        let Some(name) = args.text_or_none("back")? else {
            return Ok(None);
        };
        let at = self.place(index)?;
        let end = at * Placement::translation(0.0, 0.0, -last.end) * Placement::rotation_x(180.0);
        let open = at.point([0.0, 0.0, -last.end - 10.0 * NEAR]);
        let behind = self.solid.classify(&[open], NEAR)?;
        if !self.through && behind.first() == Some(&crate::query::Side::Inside) {
            return Err(KernelError::refused(format!(
                "the hole is {:.3} mm deep and has no far mouth for port '{}': leave depth out to go \
                 through, or leave back out",
                self.depth,
                clip(name)
            )));
        }
        let name = numbered(name, self.at.len(), index);
        make(&name, &end, last.end - last.mouth.max(wide)).map(Some)
    }

    fn place(&self, index: usize) -> Result<Placement> {
        self.at
            .get(index)
            .copied()
            .ok_or_else(|| KernelError::internal("a hole has no place"))
    }

    /// Cuts, and makes a port for each hole of a diameter, which is wider down to `wide`: `make` is told
    /// name, place of the mouth and depth.
    fn with_ports(
        &self,
        args: &Args<'_>,
        tool: &Shape,
        (diameter, wide): (f64, f64),
        back_type: PortType,
        make: impl Fn(&str, &Placement, f64) -> Result<Port>,
    ) -> Result<Value> {
        let (cut, bores) = self.cut(tool, diameter)?;
        let base = args.text("name")?;
        let mut ports = Vec::new();
        for (index, (first, last)) in bores.iter().enumerate() {
            let at = self.place(index)?;
            let name = numbered(base, bores.len(), index);
            ports.push(make(&name, &at, first.end)?);
            ports.extend(self.back(args, index, last, wide, |name, at, depth| {
                let found = params([("diameter", diameter), ("depth", depth)]);
                port(name, back_type, at, found)
            })?);
        }
        self.finish(args, cut, ports)
    }
}

/// The FLAT_FACE port in the middle of a pattern: the largest square about it on the face.
fn pattern_center(node: &Node, name: &str, at: &[Placement]) -> Result<Port> {
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

/// `bore_port(name, diameter, depth, back, center)`.
pub(super) fn bore(args: &Args<'_>) -> Result<Value> {
    let drilled = Drilled::of(args)?;
    let diameter = args.length("diameter")?;
    let tool = drill(diameter, drilled.depth)?;
    drilled.with_ports(
        args,
        &tool,
        (diameter, 0.0),
        PortType::Bore,
        |name, at, depth| {
            let found = params([("diameter", diameter), ("depth", depth)]);
            port(name, PortType::Bore, at, found)
        },
    )
}

/// `hole_with_port(name, diameter, depth, bolt_diameter, back, center)`.
pub(super) fn hole(args: &Args<'_>) -> Result<Value> {
    let drilled = Drilled::of(args)?;
    let diameter = args.length("diameter")?;
    let bolt = args.real_or_none("bolt_diameter")?;
    let tool = drill(diameter, drilled.depth)?;
    let make = |name: &str, at: &Placement, depth: f64| match bolt {
        Some(bolt) => port(
            name,
            PortType::ClearanceHole,
            at,
            params([
                ("diameter", diameter),
                ("depth", depth),
                ("bolt_diameter", bolt),
            ]),
        ),
        None => port(
            name,
            PortType::Hole,
            at,
            params([("diameter", diameter), ("depth", depth)]),
        ),
    };
    drilled.with_ports(args, &tool, (diameter, 0.0), PortType::Hole, make)
}

/// `cbore_hole_with_port(name, diameter, cboreDiameter, cboreDepth, depth, back, center)`.
pub(super) fn cbore(args: &Args<'_>) -> Result<Value> {
    let drilled = Drilled::of(args)?;
    let (narrow, wide) = (args.length("diameter")?, args.length("cboreDiameter")?);
    let floor = args.length("cboreDepth")?;
    let tool = drill(narrow, drilled.depth)?.fused(&[&drill(wide, floor)?], false, None)?;
    drilled.with_ports(
        args,
        &tool,
        (narrow, floor),
        PortType::Hole,
        |name, at, depth| {
            let at = *at * Placement::translation(0.0, 0.0, -floor);
            let found = params([
                ("diameter", wide),
                ("depth", floor),
                ("hole_diameter", narrow),
                ("hole_depth", depth - floor),
            ]);
            port(name, PortType::CboreSeat, &at, found)
        },
    )
}

/// `csk_hole_with_port(name, diameter, cskDiameter, cskAngle, depth, back, center)`.
pub(super) fn csk(args: &Args<'_>) -> Result<Value> {
    let drilled = Drilled::of(args)?;
    let (narrow, wide) = (args.length("diameter")?, args.length("cskDiameter")?);
    let (cone, height) = countersink(wide, args.real("cskAngle")?)?;
    // The cone meets the hole where its diameter has come down to the hole's.
    let below = height * (1.0 - narrow / wide);
    if below <= 0.0 {
        return Err(KernelError::refused(format!(
            "the countersink of diameter {wide} mm is no wider than the hole of {narrow} mm"
        )));
    }
    let tool = drill(narrow, drilled.depth)?.fused(&[&cone], false, None)?;
    drilled.with_ports(
        args,
        &tool,
        (narrow, below),
        PortType::Hole,
        |name, at, depth| {
            let at = *at * Placement::translation(0.0, 0.0, -below);
            let found = params([("diameter", narrow), ("depth", depth - below)]);
            port(name, PortType::Hole, &at, found)
        },
    )
}

/// `tapped_hole_with_port(name, diameter, pitch, depth, hand, modelled_diameter, back, center)`.
pub(super) fn tapped(args: &Args<'_>) -> Result<Value> {
    let drilled = Drilled::of(args)?;
    let (diameter, pitch) = (args.length("diameter")?, args.length("pitch")?);
    let modelled = match args.real_or_none("modelled_diameter")? {
        Some(modelled) => modelled,
        None => diameter - MINOR * pitch,
    };
    let hand = if args.text("hand")? == "left" {
        -1.0
    } else {
        1.0
    };
    let tool = drill(modelled, drilled.depth)?;
    let make = |name: &str, at: &Placement, depth: f64| {
        let found = params([
            ("diameter", diameter),
            ("pitch", pitch),
            ("hand", hand),
            ("depth", depth),
            ("modelled_diameter", modelled),
        ]);
        port(name, PortType::ThreadInternal, at, found)
    };
    let (cut, bores) = drilled.cut(&tool, modelled)?;
    let base = args.text("name")?;
    let mut ports = Vec::new();
    for (index, (first, last)) in bores.iter().enumerate() {
        let at = drilled.place(index)?;
        ports.push(make(&numbered(base, bores.len(), index), &at, first.end)?);
        ports.extend(drilled.back(args, index, last, 0.0, make)?);
    }
    drilled.finish(args, cut, ports)
}

/// What is made at each place, joined to the chain's solid where there is one.
fn grown(
    args: &Args<'_>,
    made: &Shape,
    ports: Vec<(String, Placement, PortType, Params)>,
) -> Result<Value> {
    let node = args.on()?;
    let mut tools = Vec::new();
    for place in places(&node)? {
        tools.push(made.moved(&(node.plane * place))?.baked()?);
    }
    let joined = match node.find_solid()? {
        Some(base) => safe_union(&base, &tools, false, None)?.cleaned()?,
        None if tools.len() == 1 => tools.remove(0),
        None => Shape::compound(&tools.iter().collect::<Vec<&Shape>>())?,
    };
    let ports = ports
        .into_iter()
        .map(|(name, at, port_type, found)| port(&name, port_type, &at, found))
        .collect::<Result<Vec<Port>>>()?;
    with(&node.next_shape(joined), ports)
}

/// The same port at every place, `shift` away from it.
fn at_places(
    args: &Args<'_>,
    shift: &Placement,
    port_type: PortType,
    found: &Params,
) -> Result<Vec<(String, Placement, PortType, Params)>> {
    let node = args.on()?;
    let places = places(&node)?;
    let base = args.text("name")?;
    Ok(places
        .iter()
        .enumerate()
        .map(|(index, place)| {
            (
                numbered(base, places.len(), index),
                node.plane * *place * *shift,
                port_type,
                found.clone(),
            )
        })
        .collect())
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
    let node = args.on()?;
    let at: Vec<Placement> = places(&node)?
        .into_iter()
        .map(|place| node.plane * place)
        .collect();
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
    let ports = at_places(args, &Placement::IDENTITY, kind.port_type, &found)?
        .into_iter()
        .map(|(name, at, port_type, found)| port(&name, port_type, &at, found))
        .collect::<Result<Vec<Port>>>()?;
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
