//! What calls of a recipe give: chains of workplanes, shapes, locations.

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::rc::Rc;

use assemcad_model::frame::Placement;
use assemcad_model::ports::Port;
use nalgebra::Vector3;

use crate::brep::Topology;
use crate::error::{KernelError, Result};
use crate::shape::Shape;

/// A point or direction.
pub(super) type Vector = Vector3<f64>;

/// Something on the stack of a workplane.
#[derive(Debug, Clone)]
pub(super) enum Object {
    /// A point in the world.
    Point(Vector),
    /// A place, in the workplane's own coordinates.
    Place(Placement),
    /// A shape in the world.
    Shape(Rc<Shape>),
}

impl Object {
    pub(super) fn shape(shape: Shape) -> Self {
        Self::Shape(Rc::new(shape))
    }

    pub(super) fn as_shape(&self) -> Option<&Rc<Shape>> {
        match self {
            Self::Shape(shape) => Some(shape),
            _ => None,
        }
    }

    /// The shape, where it is of this kind.
    pub(super) fn of(&self, kind: Topology) -> Result<Option<&Rc<Shape>>> {
        match self.as_shape() {
            Some(shape) if shape.topology()? == kind => Ok(Some(shape)),
            _ => Ok(None),
        }
    }

    /// What it is, in plain words.
    pub(super) fn describe(&self) -> String {
        match self {
            Self::Point(_) => "a point".to_owned(),
            Self::Place(_) => "a location".to_owned(),
            Self::Shape(shape) => match shape.topology() {
                Ok(Topology::Compound) => "a compound".to_owned(),
                Ok(Topology::CompSolid) => "a compound of solids".to_owned(),
                Ok(Topology::Solid) => "a solid".to_owned(),
                Ok(Topology::Shell) => "a shell".to_owned(),
                Ok(Topology::Face) => "a face".to_owned(),
                Ok(Topology::Wire) => "a wire".to_owned(),
                Ok(Topology::Edge) => "an edge".to_owned(),
                Ok(Topology::Vertex) => "a vertex".to_owned(),
                Err(_) => "a shape".to_owned(),
            },
        }
    }
}

/// What is drawn and not used yet, and the tags: shared by all workplanes of a chain.
#[derive(Debug, Default)]
pub(super) struct Context {
    pub(super) edges: Vec<Rc<Shape>>,
    pub(super) wires: Vec<Rc<Shape>>,
    /// Where the outline that is being drawn began, in local coordinates.
    pub(super) first_point: Option<Vector>,
    pub(super) tags: BTreeMap<String, Rc<Node>>,
}

/// One link of a chain: a plane, a stack of objects, and what came before.
#[derive(Debug)]
pub(super) struct Node {
    /// Maps local coordinates to the world's.
    pub(super) plane: Placement,
    pub(super) objects: Vec<Object>,
    pub(super) parent: Option<Rc<Node>>,
    pub(super) context: Rc<RefCell<Context>>,
    /// The ports that the part has so far, in the world.
    pub(super) ports: Rc<Vec<Port>>,
}

impl Node {
    /// A chain's first link.
    pub(super) fn begin(plane: Placement, objects: Vec<Object>) -> Rc<Self> {
        Rc::new(Self {
            plane,
            objects,
            parent: None,
            context: Rc::default(),
            ports: Rc::default(),
        })
    }

    /// The next link: same plane, other objects.
    pub(super) fn next(self: &Rc<Self>, objects: Vec<Object>) -> Rc<Self> {
        self.next_on(self.plane, objects)
    }

    /// The next link on another plane.
    pub(super) fn next_on(self: &Rc<Self>, plane: Placement, objects: Vec<Object>) -> Rc<Self> {
        Rc::new(Self {
            plane,
            objects,
            parent: Some(Rc::clone(self)),
            context: Rc::clone(&self.context),
            ports: Rc::clone(&self.ports),
        })
    }

    /// The next link with one shape on its stack.
    pub(super) fn next_shape(self: &Rc<Self>, shape: Shape) -> Rc<Self> {
        self.next(vec![Object::shape(shape)])
    }

    /// The same link with other ports.
    pub(super) fn with_ports(self: &Rc<Self>, ports: Vec<Port>) -> Rc<Self> {
        Rc::new(Self {
            plane: self.plane,
            objects: self.objects.clone(),
            parent: self.parent.clone(),
            context: Rc::clone(&self.context),
            ports: Rc::new(ports),
        })
    }

    pub(super) fn to_world(&self, local: Vector) -> Vector {
        self.plane.point(local.into()).into()
    }

    pub(super) fn to_local(&self, world: Vector) -> Vector {
        self.plane.inverse().point(world.into()).into()
    }

    pub(super) fn origin(&self) -> Vector {
        self.plane.origin()
    }

    pub(super) fn z(&self) -> Vector {
        let [_, _, z] = self.plane.axes();
        z
    }

    /// The first object, or the plane's origin where there is none.
    pub(super) fn first(&self) -> Object {
        self.objects
            .first()
            .cloned()
            .unwrap_or_else(|| Object::Point(self.origin()))
    }

    /// The shapes on the stack.
    pub(super) fn shapes(&self) -> impl Iterator<Item = &Rc<Shape>> {
        self.objects.iter().filter_map(Object::as_shape)
    }

    /// The solids on the stack, those of compounds one by one.
    pub(super) fn solids_on_stack(&self) -> Result<Vec<Shape>> {
        let mut found = Vec::new();
        for shape in self.shapes() {
            match shape.topology()? {
                Topology::Solid => found.push(shape.try_clone()?),
                Topology::Compound => found.extend(shape.parts(Topology::Solid)?),
                _ => {}
            }
        }
        Ok(found)
    }

    /// The solids of the nearest link that has some, as a compound: what a chain works on.
    pub(super) fn find_solid(&self) -> Result<Option<Shape>> {
        self.search(true, true)
    }

    pub(super) fn search(&self, stack: bool, parents: bool) -> Result<Option<Shape>> {
        let before = self.parent.as_deref().filter(|_| parents);
        let chain = core::iter::successors(before, |node| node.parent.as_deref());
        for node in Some(self).filter(|_| stack).into_iter().chain(chain) {
            let found = node.solids_on_stack()?;
            if !found.is_empty() {
                let all: Vec<&Shape> = found.iter().collect();
                return Ok(Some(Shape::compound(&all)?));
            }
        }
        Ok(None)
    }

    /// The chain's solid.
    ///
    /// # Errors
    /// When there is none.
    pub(super) fn solid(&self) -> Result<Shape> {
        self.find_solid()?.ok_or_else(|| {
            KernelError::refused(
                "there is no solid in this chain: make one before, for example by box or extrude",
            )
        })
    }
}

impl Drop for Node {
    /// A long chain is taken apart link by link: by recursion it could exhaust the stack.
    fn drop(&mut self) {
        let mut link = self.parent.take();
        while let Some(node) = link {
            link = match Rc::try_unwrap(node) {
                Ok(mut node) => node.parent.take(),
                Err(_) => None,
            };
        }
    }
}

/// What a call gave.
#[derive(Debug, Clone)]
pub(super) enum Value {
    Node(Rc<Node>),
    Object(Object),
    Objects(Vec<Object>),
    Place(Placement),
    /// Known only when a function of `each` or `eachpoint` is applied.
    Later,
}
