//! The methods of `Solid`.
#![allow(missing_docs, reason = "the macro makes public items of the methods")]

use std::collections::BTreeMap;

use assemcad_model::frame::Placement;
use assemcad_model::param::clip;
use assemcad_model::ports::{self, PortType};
use assemcad_model::recipe::Op;
use starlark::environment::MethodsBuilder;
use starlark::eval::Evaluator;
use starlark::starlark_module;
use starlark::values::Value;
use starlark::values::dict::DictRef;

use super::plain::{Edges, Frame};
use super::solid::Solid;
use crate::fault::Fault;
use crate::language::{number, positive, vector};

fn two(a: (&str, f64), b: (&str, f64)) -> BTreeMap<String, f64> {
    BTreeMap::from([(a.0.to_owned(), a.1), (b.0.to_owned(), b.1)])
}

fn port_type(word: &str) -> Result<PortType, Fault> {
    let names: Vec<&str> = ports::ALL.iter().map(|k| k.name).collect();
    ports::ALL
        .iter()
        .find(|k| k.name == word)
        .map(|k| k.port_type)
        .ok_or_else(|| {
            Fault::new(format!("there is no port type '{}'", clip(word)))
                .hint(format!("port types are {}", names.join(", ")))
        })
}

#[starlark_module]
pub(super) fn solid_methods(builder: &mut MethodsBuilder) {
    /// The names of the ports, in order of declaration.
    #[starlark(attribute)]
    fn port_names(this: &Solid) -> anyhow::Result<Vec<String>> {
        Ok(this.ports.iter().map(|p| p.name.clone()).collect())
    }

    /// `fuse(other)`: the union; keeps the ports of both.
    fn fuse<'v>(
        this: &Solid,
        other: &'v Solid,
        eval: &mut Evaluator<'v, '_, '_>,
    ) -> anyhow::Result<Solid> {
        let fused = this.after(
            Op::Fuse {
                a: this.node,
                b: other.node,
            },
            eval,
        )?;
        Ok(fused.with_ports(other.ports.as_ref().clone(), eval)?)
    }

    /// `cut(tool)`: without the tool; keeps the ports of the solid that is cut.
    fn cut<'v>(
        this: &Solid,
        tool: &'v Solid,
        eval: &mut Evaluator<'v, '_, '_>,
    ) -> anyhow::Result<Solid> {
        Ok(this.after(
            Op::Cut {
                a: this.node,
                b: tool.node,
            },
            eval,
        )?)
    }

    /// `common(other)`: what both have in common; keeps the ports of the first.
    fn common<'v>(
        this: &Solid,
        other: &'v Solid,
        eval: &mut Evaluator<'v, '_, '_>,
    ) -> anyhow::Result<Solid> {
        Ok(this.after(
            Op::Common {
                a: this.node,
                b: other.node,
            },
            eval,
        )?)
    }

    /// `fillet(edges, radius)`: rounded edges.
    fn fillet<'v>(
        this: &Solid,
        edges: &'v Edges,
        radius: Value<'v>,
        eval: &mut Evaluator<'v, '_, '_>,
    ) -> anyhow::Result<Solid> {
        let radius = positive(radius, "radius")?;
        Ok(this.after(
            Op::Fillet {
                of: this.node,
                edges: edges.edges.clone(),
                radius,
            },
            eval,
        )?)
    }

    /// `chamfer(edges, distance)`: bevelled edges.
    fn chamfer<'v>(
        this: &Solid,
        edges: &'v Edges,
        distance: Value<'v>,
        eval: &mut Evaluator<'v, '_, '_>,
    ) -> anyhow::Result<Solid> {
        let distance = positive(distance, "distance")?;
        Ok(this.after(
            Op::Chamfer {
                of: this.node,
                edges: edges.edges.clone(),
                distance,
            },
            eval,
        )?)
    }

    /// `translate(x, y, z)`: moved; the ports move along.
    fn translate<'v>(
        this: &Solid,
        x: Value<'v>,
        y: Value<'v>,
        z: Value<'v>,
        eval: &mut Evaluator<'v, '_, '_>,
    ) -> anyhow::Result<Solid> {
        let by = Placement::translation(number(x, "x")?, number(y, "y")?, number(z, "z")?);
        Ok(this.placed(&by, eval)?)
    }

    /// `rotate(point, direction, angle_deg)`: turned about an axis, right-handed; the ports turn along.
    fn rotate<'v>(
        this: &Solid,
        point: Value<'v>,
        direction: Value<'v>,
        angle_deg: Value<'v>,
        eval: &mut Evaluator<'v, '_, '_>,
    ) -> anyhow::Result<Solid> {
        let (point, axis) = (vector(point, "point")?, vector(direction, "direction")?);
        match Placement::rotation_about(point, axis, number(angle_deg, "angle_deg")?) {
            Ok(by) => Ok(this.placed(&by, eval)?),
            Err(_) => Fault::new("the direction of the axis has no length").raise(),
        }
    }

    /// `without_ports()`: the same solid with no ports.
    fn without_ports(this: &Solid) -> anyhow::Result<Solid> {
        Ok(Solid::new(this.node))
    }

    /// `bore_port(name, at, diameter, depth)`: a hole from the mouth at `at` inwards, against z of
    /// `at`, and its BORE port.
    ///
    /// The tool ends flush with the mouth and at exactly the depth. Reaching out of the mouth would cut
    /// whatever stands in front of it (a collar, a second wall) and make the recipe's numbers other
    /// than the port's; a flush end in a plane mouth is exact in the kernel.
    fn bore_port<'v>(
        this: &Solid,
        name: &str,
        at: &'v Frame,
        diameter: Value<'v>,
        depth: Value<'v>,
        eval: &mut Evaluator<'v, '_, '_>,
    ) -> anyhow::Result<Solid> {
        let (diameter, depth) = (positive(diameter, "diameter")?, positive(depth, "depth")?);
        let tool = Solid::tool(at, -depth, diameter, depth, eval)?;
        let params = two(("diameter", diameter), ("depth", depth));
        let cut = this.after(
            Op::Cut {
                a: this.node,
                b: tool,
            },
            eval,
        )?;
        Ok(cut.with_port(name, PortType::Bore, at, params, eval)?)
    }

    /// `shaft_port(name, at, diameter, length)`: a cylinder about z of `at`, half its length on either
    /// side of the origin, fused on, and its SHAFT port.
    fn shaft_port<'v>(
        this: &Solid,
        name: &str,
        at: &'v Frame,
        diameter: Value<'v>,
        length: Value<'v>,
        eval: &mut Evaluator<'v, '_, '_>,
    ) -> anyhow::Result<Solid> {
        let (diameter, length) = (positive(diameter, "diameter")?, positive(length, "length")?);
        let tool = Solid::tool(at, -length / 2.0, diameter, length, eval)?;
        let params = two(("diameter", diameter), ("length", length));
        let fused = this.after(
            Op::Fuse {
                a: this.node,
                b: tool,
            },
            eval,
        )?;
        Ok(fused.with_port(name, PortType::Shaft, at, params, eval)?)
    }

    /// `face_port(name, at, extent_x, extent_y)`: the FLAT_FACE port of a face that is there.
    fn face_port<'v>(
        this: &Solid,
        name: &str,
        at: &'v Frame,
        extent_x: Value<'v>,
        extent_y: Value<'v>,
        eval: &mut Evaluator<'v, '_, '_>,
    ) -> anyhow::Result<Solid> {
        let extent_x = positive(extent_x, "extent_x")?;
        let extent_y = positive(extent_y, "extent_y")?;
        let params = two(("extent_x", extent_x), ("extent_y", extent_y));
        Ok(this.with_port(name, PortType::FlatFace, at, params, eval)?)
    }

    /// `port(name, type, at, params = {...})`: a port of any type on geometry that is there.
    fn port<'v>(
        this: &Solid,
        name: &str,
        r#type: &str,
        at: &'v Frame,
        params: Value<'v>,
        eval: &mut Evaluator<'v, '_, '_>,
    ) -> anyhow::Result<Solid> {
        let Some(dict) = DictRef::from_value(params) else {
            return Fault::new("params is a dict of names and numbers").raise();
        };
        let mut params = BTreeMap::new();
        for (key, value) in dict.iter() {
            let Some(key) = key.unpack_str() else {
                return Fault::new("params is a dict of names and numbers").raise();
            };
            params.insert(key.to_owned(), number(value, &format!("'{}'", clip(key)))?);
        }
        Ok(this.with_port(name, port_type(r#type)?, at, params, eval)?)
    }
}
