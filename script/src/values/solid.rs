//! `Solid`: a recorded operation and the ports of what it makes.
#![allow(
    clippy::panic,
    reason = "derive(StarlarkPagablePanic); nothing here is ever paged out"
)]
#![allow(missing_docs, reason = "the macros make public items of the values")]
#![allow(
    unsafe_code,
    reason = "derive(ProvidesStaticType) implements an unsafe trait; none of ours"
)]

use core::fmt;
use std::collections::BTreeMap;
use std::sync::Arc;

use allocative::Allocative;
use assemcad_model::frame::Placement;
use assemcad_model::name;
use assemcad_model::param::clip;
use assemcad_model::ports::{self, Port, PortType};
use assemcad_model::recipe::Op;
use starlark::environment::{Methods, MethodsBuilder};
use starlark::eval::Evaluator;
use starlark::values::dict::DictRef;
use starlark::values::{
    NoSerialize, ProvidesStaticType, StarlarkPagablePanic, StarlarkValue, Value, starlark_value,
};
use starlark::{starlark_module, starlark_simple_value};

use super::plain::{Edges, Frame, shift};
use crate::fault::Fault;
use crate::language::session::{Session, line};
use crate::language::{number, positive, vector};

/// A solid that is to be made. Immutable: every method gives a new one.
#[derive(Debug, Clone, ProvidesStaticType, NoSerialize, Allocative, StarlarkPagablePanic)]
pub(crate) struct Solid {
    /// The operation that makes it.
    pub(crate) node: u32,
    #[allocative(skip)]
    pub(crate) ports: Arc<Vec<Port>>,
}
starlark_simple_value!(Solid);
starlark::methods_static!(SOLID_METHODS = solid_methods);

impl fmt::Display for Solid {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "<Solid with {} ports>", self.ports.len())
    }
}

#[starlark_value(type = "Solid")]
impl<'v> StarlarkValue<'v> for Solid {
    fn get_methods() -> Option<&'static Methods> {
        Some(SOLID_METHODS.methods())
    }
}

impl Solid {
    pub(crate) fn new(node: u32) -> Self {
        Self {
            node,
            ports: Arc::new(Vec::new()),
        }
    }

    /// The solid that an operation on this one makes, with the same ports.
    fn after(&self, op: Op, eval: &Evaluator<'_, '_, '_>) -> Result<Self, Fault> {
        let node = Session::of(eval)?
            .recorder
            .borrow_mut()
            .record(op, line(eval))?;
        Ok(Self {
            node,
            ports: Arc::clone(&self.ports),
        })
    }

    /// The solid with one port more.
    fn with_port(
        &self,
        name: &str,
        port_type: PortType,
        at: &Frame,
        params: BTreeMap<String, f64>,
        eval: &Evaluator<'_, '_, '_>,
    ) -> Result<Self, Fault> {
        if !name::is_valid(name) {
            return Err(Fault::new(format!("'{}' cannot name a port", clip(name)))
                .hint(format!("names are {}", name::RULE)));
        }
        let port = Port {
            name: name.to_owned(),
            port_type,
            frame: at.frame,
            params,
        };
        let faults = port.faults();
        if !faults.is_empty() {
            return Err(Fault::new(format!("port '{name}': {}", faults.join("; "))));
        }
        self.with_ports(vec![port], eval)
    }

    fn with_ports(&self, more: Vec<Port>, eval: &Evaluator<'_, '_, '_>) -> Result<Self, Fault> {
        if more.is_empty() {
            return Ok(self.clone());
        }
        for port in &more {
            if self.ports.iter().any(|p| p.name == port.name) {
                return Err(
                    Fault::new(format!("there are two ports of the name '{}'", port.name))
                        .hint("give each port of a solid a name of its own"),
                );
            }
        }
        Session::of(eval)?.charge(self.ports.len() + more.len())?;
        let ports = self.ports.iter().cloned().chain(more).collect();
        Ok(Self {
            node: self.node,
            ports: Arc::new(ports),
        })
    }

    /// The solid and its ports, moved.
    fn placed(&self, by: &Placement, eval: &Evaluator<'_, '_, '_>) -> Result<Self, Fault> {
        Session::of(eval)?.charge(self.ports.len())?;
        let moved = self.after(
            Op::Place {
                of: self.node,
                placement: (*by).into(),
            },
            eval,
        )?;
        let carry = |p: &Port| Port {
            frame: by.frame(&p.frame),
            ..p.clone()
        };
        Ok(Self {
            node: moved.node,
            ports: Arc::new(self.ports.iter().map(carry).collect()),
        })
    }

    /// A cylinder about z of `at`, from `start` along z.
    fn tool(
        at: &Frame,
        start: f64,
        diameter: f64,
        height: f64,
        eval: &Evaluator<'_, '_, '_>,
    ) -> Result<u32, Fault> {
        let at = shift(&at.frame, [0.0, 0.0, start])?;
        let op = Op::Cylinder {
            at,
            radius: diameter / 2.0,
            height,
        };
        Session::of(eval)?
            .recorder
            .borrow_mut()
            .record(op, line(eval))
    }
}

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
fn solid_methods(builder: &mut MethodsBuilder) {
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
