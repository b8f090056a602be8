//! What the tests share.

use assemcad_kernel::brep::Topology;
use assemcad_kernel::{KernelError, Shape};
use assemcad_model::frame::{Frame, Placement};

/// The booleans of two solids whose result is one solid.
pub trait Two {
    fn fuse(&self, other: &Shape) -> Shape;
    fn cut(&self, tool: &Shape) -> Shape;
    fn common(&self, other: &Shape) -> Shape;
}

impl Two for Shape {
    fn fuse(&self, other: &Shape) -> Shape {
        one(&self.fused(&[other], false, None).unwrap())
    }

    fn cut(&self, tool: &Shape) -> Shape {
        one(&self.without(&[tool], None).unwrap())
    }

    fn common(&self, other: &Shape) -> Shape {
        one(&self.shared(&[other], None).unwrap())
    }
}

/// The only solid of a group, faces of one surface joined.
#[track_caller]
pub fn one(group: &Shape) -> Shape {
    let clean = group.cleaned().unwrap();
    let mut solids = clean.parts(Topology::Solid).unwrap();
    assert_eq!(solids.len(), 1);
    solids.pop().unwrap().baked().unwrap()
}

/// The edges of a solid of which this holds, asked of their middles.
pub fn edges_where(solid: &Shape, holds: impl Fn([f64; 3]) -> bool) -> Vec<Shape> {
    let mut edges = solid.parts(Topology::Edge).unwrap();
    edges.retain(|edge| holds(edge.position_at(0.5).unwrap()));
    edges
}

/// A frame at a point with the world's axes.
pub fn at(x: f64, y: f64, z: f64) -> Frame {
    Frame {
        origin: [x, y, z],
        ..Frame::WORLD
    }
}

/// A slanted frame: nothing about it is round.
pub fn slanted() -> Frame {
    let turn = Placement::rotation_about([1.0, 2.0, 3.0], [1.0, -2.0, 0.5], 37.0).unwrap();
    turn.frame(&at(4.0, -5.0, 6.0))
}

/// A box from a corner.
pub fn cuboid(corner: [f64; 3], size: [f64; 3]) -> Shape {
    Shape::cuboid(&at(corner[0], corner[1], corner[2]), size).unwrap()
}

/// A cylinder along z.
pub fn cylinder(base: [f64; 3], radius: f64, height: f64) -> Shape {
    Shape::cylinder(&at(base[0], base[1], base[2]), radius, height).unwrap()
}

pub fn volume(shape: &Shape) -> f64 {
    shape.mass().unwrap().volume
}

/// Within a relative difference, or 1e-9 absolutely near 0.
#[track_caller]
pub fn near(found: f64, expected: f64, relative: f64) {
    let slack = relative * expected.abs().max(1e-3);
    assert!(
        (found - expected).abs() <= slack,
        "found {found}, expected {expected}, off by {:e}",
        found - expected
    );
}

/// Every coordinate within a distance.
#[track_caller]
pub fn near3(found: [f64; 3], expected: [f64; 3], distance: f64) {
    for (f, e) in found.iter().zip(expected) {
        assert!(
            (f - e).abs() <= distance,
            "found {found:?}, expected {expected:?}"
        );
    }
}

/// That the message says all of these.
#[track_caller]
pub fn says(error: &KernelError, words: &[&str]) {
    for word in words {
        assert!(
            error.message.contains(word),
            "{:?} does not say {word:?}",
            error.message
        );
    }
}

/// A closed outline of lines through points in the plane z = 0.
pub fn polygon(points: &[[f64; 2]]) -> Shape {
    let points: Vec<[f64; 3]> = points.iter().map(|[x, y]| [*x, *y, 0.0]).collect();
    Shape::polyline_wire(&points, true).unwrap()
}

/// A circle in the plane z = 0.
pub fn circle(x: f64, y: f64, radius: f64) -> Shape {
    let edge = Shape::circle_edge(&Placement::translation(x, y, 0.0), radius).unwrap();
    Shape::wire(&[&edge]).unwrap()
}

/// What an outline with holes encloses, moved along z.
pub fn prism(outer: &Shape, holes: &[&Shape], height: f64) -> Shape {
    let face = Shape::face(outer, holes).unwrap();
    face.extruded([0.0, 0.0, height], 0.0).unwrap()
}
