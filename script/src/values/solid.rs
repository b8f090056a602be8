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
use assemcad_model::ports::{Port, PortType};
use assemcad_model::recipe::Op;
use starlark::environment::Methods;
use starlark::eval::Evaluator;
use starlark::starlark_simple_value;
use starlark::values::{
    NoSerialize, ProvidesStaticType, StarlarkPagablePanic, StarlarkValue, starlark_value,
};

use super::plain::{Frame, shift};
use super::solid_methods::solid_methods;
use crate::fault::Fault;
use crate::language::session::{Session, line};

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
    pub(super) fn after(&self, op: Op, eval: &Evaluator<'_, '_, '_>) -> Result<Self, Fault> {
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
    pub(super) fn with_port(
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

    pub(super) fn with_ports(
        &self,
        more: Vec<Port>,
        eval: &Evaluator<'_, '_, '_>,
    ) -> Result<Self, Fault> {
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
    pub(super) fn placed(
        &self,
        by: &Placement,
        eval: &Evaluator<'_, '_, '_>,
    ) -> Result<Self, Fault> {
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
    pub(super) fn tool(
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
