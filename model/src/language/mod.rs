//! The modelling language: every function and method with its parameters.
//!
//! One table serves all who must agree: the script front end binds arguments by it, the kernel
//! interprets recipes by it, and the page that explains the language is written from it. Names,
//! order and defaults of the `Workplane` methods are CadQuery's, so that what a model has learned of
//! CadQuery holds here.

mod ports;
mod shapes;
mod workplane;

/// Every method, group by group.
pub fn methods() -> impl Iterator<Item = &'static Method> {
    workplane::METHODS
        .iter()
        .chain(ports::METHODS)
        .chain(shapes::METHODS)
}

/// The method of a full name, such as `Workplane.box`.
#[must_use]
pub fn method(name: &str) -> Option<&'static Method> {
    methods().find(|m| m.name == name)
}

/// A function or method of the language.
#[derive(Debug)]
pub struct Method {
    /// Full name: `Workplane.box` is called on a workplane, `Solid.makeBox` is a function of `cq`.
    pub name: &'static str,
    /// What it is called on; none for a function.
    pub on: Option<Type>,
    /// Its parameters in order; any may be given by name.
    pub params: &'static [Param],
    /// What it gives.
    pub gives: Type,
    /// What it does, in one line.
    pub doc: &'static str,
}

impl Method {
    /// The name behind the point.
    #[must_use]
    pub fn short(&self) -> &'static str {
        self.name.split_once('.').map_or(self.name, |(_, s)| s)
    }
}

/// What a call may give.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Type {
    /// A stack of objects on a plane, with its chain.
    Workplane,
    /// One solid, face, wire, edge or vertex.
    Shape,
    /// A list of them.
    Shapes,
    /// A place: a frame.
    Location,
}

/// A parameter of a method.
#[derive(Debug)]
pub struct Param {
    /// Name.
    pub name: &'static str,
    /// What it takes and how a recipe writes it.
    pub kind: Kind,
    /// What it is when it is not given.
    pub default: Default,
}

/// What a parameter is when it is not given.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Default {
    /// It must be given.
    Required,
    /// None, which may be given too; the recipe leaves it out.
    None,
    /// Yes or no.
    Flag(bool),
    /// A number.
    Real(f64),
    /// A whole number.
    Count(i32),
    /// A text.
    Text(&'static str),
    /// A point or direction.
    Vector([f64; 3]),
}

/// What a parameter takes, and how a recipe writes it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// A finite number: `1.5`.
    Real,
    /// A whole number: `3`.
    Count,
    /// True or False.
    Flag,
    /// Any text.
    Text,
    /// One of some texts.
    Choice(&'static [&'static str]),
    /// A point or direction, given as `(x, y)`, `(x, y, z)` or `cq.Vector`: `[x, y, z]`.
    Vector,
    /// A list of points: `[[x, y, z], ...]`.
    Vectors,
    /// A list of directions some of which may be None: `[[x, y, z], null]`.
    MaybeVectors,
    /// A list of numbers.
    Reals,
    /// True, False or two of them: `[true, false]`.
    Flags2,
    /// True, False or three of them: `[true, true, false]`.
    Flags3,
    /// How a new solid joins the one of the chain, given as True, False, "a", "s" or "cut":
    /// `"add"`, `"none"` or `"cut"`.
    Combine,
    /// A selector's text or a selector object: [`crate::selector::Selector`] as JSON.
    Selector,
    /// A length, "next", "last" or a face: a number, a text or a reference.
    Until,
    /// A plane's name or a `cq.Plane`: a text or a [`crate::frame::Frame`].
    Plane,
    /// What a workplane begins on: a plane's name, a `cq.Plane`, or a shape.
    PlaneOrShape,
    /// A plane's name, a normal, a face or a workplane with one on its stack.
    MirrorPlane,
    /// A `cq.Location`: a [`crate::frame::Frame`] or a reference.
    Location,
    /// A list of points and locations: vectors, frames and references.
    Places,
    /// A workplane: a reference.
    Workplane,
    /// A workplane or shape: a reference.
    Solid,
    /// A workplane, a shape or a list of shapes: a reference or a list of references.
    Solids,
    /// A workplane, a shape, or a function of a location that gives one: a reference; for a function
    /// to what it gave for the call `cq.eachLocation` which the argument `variable` names.
    PerLocation,
    /// A function of one object of the stack that gives a shape: as above, with `cq.eachObject`.
    PerObject,
    /// Parameters of a port: a dict of names and numbers.
    PortParams,
    /// Segments of a closed outline, written by the front end: [`Outline`](crate::language::Outline).
    Outline,
}

/// A closed outline of lines and arcs in a workplane, in its local coordinates.
#[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Outline {
    /// First point.
    pub start: [f64; 2],
    /// The segments in order; the last one ends at the start.
    pub segments: Vec<Segment>,
}

/// One piece of an outline, from where the last one ended.
#[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Segment {
    /// A straight line.
    Line {
        /// End point.
        to: [f64; 2],
    },
    /// A circular arc through a point.
    Arc {
        /// A point between start and end.
        via: [f64; 2],
        /// End point.
        to: [f64; 2],
    },
}

const fn required(name: &'static str, kind: Kind) -> Param {
    Param {
        name,
        kind,
        default: Default::Required,
    }
}

const fn optional(name: &'static str, kind: Kind) -> Param {
    Param {
        name,
        kind,
        default: Default::None,
    }
}

const fn flag(name: &'static str, default: bool) -> Param {
    Param {
        name,
        kind: Kind::Flag,
        default: Default::Flag(default),
    }
}

const fn real(name: &'static str, default: f64) -> Param {
    Param {
        name,
        kind: Kind::Real,
        default: Default::Real(default),
    }
}

const fn count(name: &'static str, default: i32) -> Param {
    Param {
        name,
        kind: Kind::Count,
        default: Default::Count(default),
    }
}

const fn text(name: &'static str, kind: Kind, default: &'static str) -> Param {
    Param {
        name,
        kind,
        default: Default::Text(default),
    }
}

const fn vector(name: &'static str, default: [f64; 3]) -> Param {
    Param {
        name,
        kind: Kind::Vector,
        default: Default::Vector(default),
    }
}

/// `centered = True`, for two or three directions.
const fn centered(kind: Kind) -> Param {
    Param {
        name: "centered",
        kind,
        default: Default::Flag(true),
    }
}

/// `combine`, which joins the new solid to the chain's unless it says otherwise.
const fn combine(default: bool) -> Param {
    Param {
        name: "combine",
        kind: Kind::Combine,
        default: Default::Flag(default),
    }
}
