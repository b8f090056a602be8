//! Holes and their ports.

use std::rc::Rc;

use assemcad_model::frame::{Frame, Placement};
use assemcad_model::param::clip;
use assemcad_model::ports::{Port, PortType};

use super::args::Args;
use super::combine::cut;
use super::each::world_places;
use super::ports::{numbered, params, pattern_center, port, with};
use super::solid::{countersink, drill, through};
use super::value::{Node, Value};
use crate::brep::Topology;
use crate::error::{KernelError, Result};
use crate::query::Bounds;
use crate::shape::Shape;

/// How far, in mm, a hole's mouth may be from the workplane, and a measured depth from the stated one.
const NEAR: f64 = 1e-4;

/// D1 = D - 2 * 5/8 * H with H = sqrt(3)/2 * P: the minor diameter of an internal thread (ISO 68-1,
/// ISO 724).
const MINOR: f64 = 1.082_531_754_730_548_3;

/// A piece of a hole: from its mouth to its end, below the workplane.
struct Bore {
    mouth: f64,
    end: f64,
}

/// Where a drill takes material away at each of some places, by pieces, uppermost first.
fn pieces(solid: &Shape, diameter: f64, depth: f64, at: &[Placement]) -> Result<Vec<Vec<Bore>>> {
    let mut found = Vec::new();
    for place in at {
        let down = (*place * Placement::rotation_x(180.0)).frame(&Frame::WORLD);
        let Some(known) = solid.bores(&down, diameter / 2.0, depth)? else {
            return drilled(solid, &drill(diameter, depth)?, at);
        };
        let known = known.into_iter().map(|(mouth, end)| Bore { mouth, end });
        found.push(known.collect());
    }
    Ok(found)
}

/// The same by booleans. Tools whose boxes are apart are tried together: what costs is the solid's faces.
fn drilled(solid: &Shape, plain: &Shape, at: &[Placement]) -> Result<Vec<Vec<Bore>>> {
    let tools = at
        .iter()
        .map(|at| Ok((plain.moved(at)?, *at)))
        .collect::<Result<Vec<_>>>()?;
    let boxes = tools
        .iter()
        .map(|(tool, _)| tool.bounds())
        .collect::<Result<Vec<Bounds>>>()?;
    let apart = boxes.iter().enumerate().all(|(i, one)| {
        let mut others = boxes.iter().skip(i + 1);
        others.all(|other| one.common(other).is_none())
    });
    let mut found: Vec<Vec<Bore>> = Vec::new();
    if apart {
        let all: Vec<&Shape> = tools.iter().map(|(tool, _)| tool).collect();
        let removed = solid.shared(&all, None)?.parts(Topology::Solid)?;
        let mut middles = Vec::new();
        for piece in &removed {
            middles.push(piece.bounds()?.middle());
        }
        for ((_, at), own) in tools.iter().zip(&boxes) {
            let theirs = removed.iter().zip(&middles);
            let theirs = theirs.filter(|(_, middle)| own.holds(middle));
            found.push(bores(theirs.map(|(piece, _)| piece), at)?);
        }
    } else {
        for (tool, at) in &tools {
            let removed = solid.shared(&[tool], None)?.parts(Topology::Solid)?;
            found.push(bores(removed.iter(), at)?);
        }
    }
    Ok(found)
}

/// Pieces of a hole as they lie along its axis, uppermost first.
fn bores<'a>(pieces: impl Iterator<Item = &'a Shape>, at: &Placement) -> Result<Vec<Bore>> {
    let mut found = Vec::new();
    for piece in pieces {
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
        let at = world_places(&node)?;
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
        let found = pieces(&self.solid, diameter, self.depth, &self.at)?;
        let (mut tools, mut bores) = (Vec::new(), Vec::new());
        for (at, mut found) in self.at.iter().zip(found) {
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
    /// name, place of the mouth and depth, and so is `make_back` for the far mouth.
    fn with_ports(
        &self,
        args: &Args<'_>,
        tool: &Shape,
        (diameter, wide): (f64, f64),
        make: impl Fn(&str, &Placement, f64) -> Result<Port>,
        make_back: impl Fn(&str, &Placement, f64) -> Result<Port>,
    ) -> Result<Value> {
        let (cut, bores) = self.cut(tool, diameter)?;
        let base = args.text("name")?;
        let mut ports = Vec::new();
        for (index, (first, last)) in bores.iter().enumerate() {
            let at = self.place(index)?;
            let name = numbered(base, bores.len(), index);
            ports.push(make(&name, &at, first.end)?);
            ports.extend(self.back(args, index, last, wide, &make_back)?);
        }
        self.finish(args, cut, ports)
    }
}

/// What makes the port of a plain hole.
fn plain(
    port_type: PortType,
    diameter: f64,
) -> impl Fn(&str, &Placement, f64) -> Result<Port> + Copy {
    move |name, at, depth| {
        let found = params([("diameter", diameter), ("depth", depth)]);
        port(name, port_type, at, found)
    }
}

/// `bore_port(name, diameter, depth, back, center)`.
pub(super) fn bore(args: &Args<'_>) -> Result<Value> {
    let drilled = Drilled::of(args)?;
    let diameter = args.length("diameter")?;
    let tool = drill(diameter, drilled.depth)?;
    let make = plain(PortType::Bore, diameter);
    drilled.with_ports(args, &tool, (diameter, 0.0), make, make)
}

/// `hole_with_port(name, diameter, depth, bolt_diameter, back, center)`.
pub(super) fn hole(args: &Args<'_>) -> Result<Value> {
    let drilled = Drilled::of(args)?;
    let diameter = args.length("diameter")?;
    let bolt = args.real_or_none("bolt_diameter")?;
    let tool = drill(diameter, drilled.depth)?;
    let hole = plain(PortType::Hole, diameter);
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
        None => hole(name, at, depth),
    };
    drilled.with_ports(args, &tool, (diameter, 0.0), make, hole)
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
        plain(PortType::Hole, narrow),
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
    let hole = plain(PortType::Hole, narrow);
    drilled.with_ports(
        args,
        &tool,
        (narrow, below),
        |name, at, depth| {
            let at = *at * Placement::translation(0.0, 0.0, -below);
            hole(name, &at, depth - below)
        },
        hole,
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
    drilled.with_ports(args, &tool, (modelled, 0.0), make, make)
}

#[cfg(test)]
mod tests {
    use super::{Bore, drill, drilled, pieces};
    use crate::shape::Shape;
    use assemcad_model::frame::{Frame, Placement};

    fn cuboid(corner: [f64; 3], size: [f64; 3]) -> Shape {
        let frame = Frame {
            origin: corner,
            ..Frame::WORLD
        };
        Shape::cuboid(&frame, size).unwrap()
    }

    /// A channel open to +x: floor from z = 0 to 4, roof from z = 14 to 20, a bore of 8 mm along z in both.
    fn channel() -> Shape {
        let block = cuboid([0.0; 3], [40.0, 30.0, 20.0]);
        let slot = cuboid([10.0, -1.0, 4.0], [40.0, 32.0, 10.0]);
        let at = Placement::translation(30.0, 15.0, -1.0);
        let bore = Shape::cylinder_part(&at, 4.0, 30.0, 360.0).unwrap();
        block.without(&[&slot, &bore], None).unwrap()
    }

    /// The pieces of a hole of 3 mm, by lines and by a boolean, where both know them.
    #[track_caller]
    fn both(
        solid: &Shape,
        at: Placement,
        depth: f64,
        expected: &[(f64, f64)],
        in_closed_form: bool,
    ) {
        let down = (at * Placement::rotation_x(180.0)).frame(&Frame::WORLD);
        let known = solid.bores(&down, 1.5, depth).unwrap();
        assert_eq!(known.is_some(), in_closed_form);
        let by_boolean = drilled(solid, &drill(3.0, depth).unwrap(), &[at]).unwrap();
        let found = pieces(solid, 3.0, depth, &[at]).unwrap();
        for found in [by_boolean, found] {
            let found: Vec<(f64, f64)> = found[0]
                .iter()
                .map(|Bore { mouth, end }| (*mouth, *end))
                .collect();
            assert_eq!(found.len(), expected.len(), "{found:?}");
            for ((mouth, end), (from, to)) in found.iter().zip(expected) {
                assert!(
                    (mouth - from).abs() < 1e-6 && (end - to).abs() < 1e-6,
                    "{found:?}"
                );
            }
        }
    }

    #[test]
    fn pieces_by_lines_are_those_of_booleans() {
        let (solid, over) = (channel(), |x: f64, z: f64| {
            Placement::translation(x, 8.0, z)
        });
        // Through roof and floor, from the top or from 5 mm above.
        both(
            &solid,
            over(20.0, 20.0),
            50.0,
            &[(0.0, 6.0), (16.0, 20.0)],
            true,
        );
        both(
            &solid,
            over(20.0, 25.0),
            50.0,
            &[(5.0, 11.0), (21.0, 25.0)],
            true,
        );
        // To a depth in the roof, in the gap, in the floor.
        both(&solid, over(20.0, 20.0), 4.0, &[(0.0, 4.0)], true);
        both(&solid, over(20.0, 20.0), 9.0, &[(0.0, 6.0)], true);
        both(
            &solid,
            over(20.0, 20.0),
            18.0,
            &[(0.0, 6.0), (16.0, 18.0)],
            true,
        );
        // From within the roof, from the gap, and nothing at all.
        both(
            &solid,
            over(20.0, 17.0),
            50.0,
            &[(0.0, 3.0), (13.0, 17.0)],
            true,
        );
        both(&solid, over(20.0, 10.0), 50.0, &[(6.0, 10.0)], true);
        both(&solid, over(20.0, 10.0), 5.0, &[], true);
        both(&solid, over(50.0, 20.0), 50.0, &[], true);
        // Within the web, between its faces.
        both(&solid, over(5.0, 18.0), 10.0, &[(0.0, 10.0)], true);
        // Within the bore, about its axis.
        let axis = Placement::translation(30.0, 15.0, 20.0);
        both(&solid, axis, 50.0, &[], true);
    }

    #[test]
    fn what_is_in_the_way_is_left_to_booleans() {
        let solid = channel();
        // On the web's edge, on the rim of the plate, on the wall of the bore.
        both(
            &solid,
            Placement::translation(10.0, 8.0, 20.0),
            50.0,
            &[(0.0, 20.0)],
            false,
        );
        both(
            &solid,
            Placement::translation(20.0, 0.0, 20.0),
            50.0,
            &[(0.0, 6.0), (16.0, 20.0)],
            false,
        );
        both(
            &solid,
            Placement::translation(26.0, 15.0, 20.0),
            50.0,
            &[(0.0, 6.0), (16.0, 20.0)],
            false,
        );
        // A ball has no plane faces.
        let ball = Shape::sphere(&Frame::WORLD, 10.0).unwrap();
        let half = (100.0_f64).sqrt();
        both(
            &ball,
            Placement::translation(0.0, 0.0, 12.0),
            50.0,
            &[(2.0, 12.0 + half)],
            false,
        );
    }

    #[test]
    fn moved_solids_are_drilled_alike() {
        let way = Placement::rotation_about([1.0, 2.0, 3.0], [1.0, -2.0, 0.5], 37.0).unwrap();
        let solid = channel().moved(&way).unwrap();
        let at = way * Placement::translation(20.0, 8.0, 20.0);
        both(&solid, at, 50.0, &[(0.0, 6.0), (16.0, 20.0)], true);
    }
}
