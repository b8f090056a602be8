//! What the tests share.

use assemcad_kernel::{KernelError, Shape};
use assemcad_model::frame::{Frame, Placement};
use assemcad_model::recipe::{Outline, Profile, Segment};

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

pub fn line(x: f64, y: f64) -> Segment {
    Segment::Line { to: [x, y] }
}

pub fn arc(via: [f64; 2], to: [f64; 2]) -> Segment {
    Segment::Arc { via, to }
}

pub fn path(start: [f64; 2], segments: Vec<Segment>) -> Outline {
    Outline::Path { start, segments }
}

/// A rectangle from (x, y) with sides w, h.
pub fn rectangle(x: f64, y: f64, w: f64, h: f64) -> Outline {
    path(
        [x, y],
        vec![line(x + w, y), line(x + w, y + h), line(x, y + h)],
    )
}

pub fn profile(outer: Outline) -> Profile {
    Profile {
        at: Frame::WORLD,
        outer,
        holes: Vec::new(),
    }
}
