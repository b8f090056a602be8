//! What the tests share.

use assemcad_kernel::brep::Topology;
use assemcad_kernel::{KernelError, Shape};
use assemcad_model::frame::Placement;

pub const WORLD: Placement = Placement::IDENTITY;

/// A rectangle in the plane z from corner to corner.
pub fn rectangle(x0: f64, y0: f64, x1: f64, y1: f64, z: f64) -> Shape {
    let points = [[x0, y0, z], [x1, y0, z], [x1, y1, z], [x0, y1, z]];
    Shape::polyline_wire(&points, true).unwrap()
}

pub fn circle(x: f64, y: f64, z: f64, radius: f64) -> Shape {
    let edge = Shape::circle_edge(&Placement::translation(x, y, z), radius).unwrap();
    Shape::wire(&[&edge]).unwrap()
}

pub fn face(outer: &Shape, holes: &[&Shape]) -> Shape {
    Shape::face(outer, holes).unwrap()
}

/// A box from the origin.
pub fn cuboid(x: f64, y: f64, z: f64) -> Shape {
    cuboid_at([0.0; 3], x, y, z)
}

pub fn cuboid_at([a, b, c]: [f64; 3], x: f64, y: f64, z: f64) -> Shape {
    face(&rectangle(a, b, a + x, b + y, c), &[])
        .extruded([0.0, 0.0, z], 0.0)
        .unwrap()
}

pub fn count(shape: &Shape, of: Topology) -> usize {
    shape.parts(of).unwrap().len()
}

pub fn volume(shape: &Shape) -> f64 {
    shape.measure().unwrap().volume
}

pub fn area(shape: &Shape) -> f64 {
    shape.measure().unwrap().area
}

pub fn length(shape: &Shape) -> f64 {
    shape.measure().unwrap().length
}

/// One valid solid, which may lie in a group.
#[track_caller]
pub fn sound(shape: &Shape) {
    assert_eq!(count(shape, Topology::Solid), 1);
    assert!(shape.is_valid().unwrap());
    assert!(volume(shape) > 0.0);
}

/// Within a relative difference, or 1e-3 of it absolutely near 0.
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

/// That it failed, and the sentence says this.
#[track_caller]
pub fn says<T>(result: Result<T, KernelError>, words: &str) {
    let Err(error) = result else {
        panic!("it went well");
    };
    assert!(
        error.message.contains(words),
        "{:?} does not say {words:?}",
        error.message
    );
}
