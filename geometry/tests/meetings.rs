//! Where solids meet, held against closed forms: areas, plays, common lengths, what each contact stops.

#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::indexing_slicing
)]

use core::f64::consts::PI;

use assemcad_geometry::narrow::Boundary;
use assemcad_geometry::narrow::meet::{Kind, Meeting, meetings};
use assemcad_kernel::Shape;
use assemcad_kernel::brep::Topology;
use assemcad_model::frame::{Frame, Placement};

fn at(x: f64, y: f64, z: f64) -> Frame {
    Frame {
        origin: [x, y, z],
        ..Frame::WORLD
    }
}

fn skin(shape: &Shape) -> Boundary {
    Boundary::new(shape.skin(0.01, 10.0).unwrap()).unwrap()
}

fn cut(of: &Shape, tool: &Shape) -> Shape {
    let clean = of.without(&[tool], None).unwrap().cleaned().unwrap();
    clean.parts(Topology::Solid).unwrap().remove(0)
}

fn plate(x: f64, y: f64, z: f64) -> Shape {
    Shape::cuboid(&at(-x / 2.0, -y / 2.0, 0.0), [x, y, z]).unwrap()
}

fn of_kind(all: &[Meeting], kind: Kind) -> Vec<&Meeting> {
    all.iter().filter(|m| m.kind == kind).collect()
}

fn near(a: f64, b: f64, tolerance: f64) {
    assert!((a - b).abs() <= tolerance, "{a} {b}");
}

#[test]
fn plates_on_each_other_meet_over_what_they_have_in_common() {
    let (a, b) = (
        skin(&plate(40.0, 30.0, 10.0)),
        skin(&plate(20.0, 20.0, 5.0)),
    );
    // Shifted so that 12 x 20 mm of the small one lie on the large one.
    let found = meetings(&a, &b, &Placement::translation(18.0, 0.0, 10.0));
    let flat = of_kind(&found, Kind::Plane);
    assert_eq!(flat.len(), 1, "{found:?}");
    near(flat[0].area_mm2, 240.0, 1e-9);
    near(flat[0].gap_mm, 0.0, 1e-12);
    // Its corners: x from 8 to 20, y from -10 to 10, in the plane z = 10; the way out of the first is up.
    assert_eq!(flat[0].spots.len(), 4);
    for s in &flat[0].spots {
        near(s.at[2], 10.0, 1e-12);
        assert_eq!(s.normal, [0.0, 0.0, 1.0]);
        assert!([8.0, 20.0].iter().any(|x| (x - s.at[0]).abs() < 1e-9));
        near(s.at[1].abs(), 10.0, 1e-9);
    }
    // 0.4 mm above it is a gap that still stops; 2 mm above it nothing is stopped.
    let found = meetings(&a, &b, &Placement::translation(0.0, 0.0, 10.4));
    near(of_kind(&found, Kind::Plane)[0].gap_mm, 0.4, 1e-9);
    assert!(meetings(&a, &b, &Placement::translation(0.0, 0.0, 12.0)).is_empty());
    // On edge to edge, or over a strip of 0.02 mm, there is no contact.
    assert!(
        of_kind(
            &meetings(&a, &b, &Placement::translation(30.0, 0.0, 10.0)),
            Kind::Plane
        )
        .is_empty()
    );
    assert!(
        of_kind(
            &meetings(&a, &b, &Placement::translation(29.98, 0.0, 10.0)),
            Kind::Plane
        )
        .is_empty()
    );
}

#[test]
fn a_pin_in_a_hole_has_its_play_its_length_and_its_circle() {
    let block = plate(60.0, 60.0, 20.0);
    let drilled = cut(
        &block,
        &Shape::cylinder(&at(0.0, 0.0, -1.0), 10.0, 22.0).unwrap(),
    );
    let pin = Shape::cylinder(&at(0.0, 0.0, 0.0), 9.9, 50.0).unwrap();
    let (a, b) = (skin(&drilled), skin(&pin));
    // From z = 12 on: 8 mm are in the hole.
    let found = meetings(&a, &b, &Placement::translation(0.0, 0.0, 12.0));
    let round = of_kind(&found, Kind::Cylinder);
    assert_eq!(round.len(), 1, "{found:?}");
    let about = round[0].about.unwrap();
    near(round[0].gap_mm, 0.1, 1e-9);
    near(about.range[1] - about.range[0], 8.0, 1e-9);
    near(about.share, 1.0, 1e-9);
    near(round[0].area_mm2, 2.0 * PI * 9.9 * 8.0, 1e-6);
    assert!(about.first_has_hole);
    for s in &round[0].spots {
        near(libm::hypot(s.at[0], s.at[1]), 9.9, 1e-9);
        near(s.gap_mm, 0.1, 1e-9);
        // Out of the block into the pin: towards the axis.
        assert!(s.at[0] * s.normal[0] + s.at[1] * s.normal[1] < -9.0);
    }
    // Pushed aside by the play it touches on one side, with twice of it on the other.
    let found = meetings(&a, &b, &Placement::translation(0.1, 0.0, 12.0));
    let gaps: Vec<f64> = of_kind(&found, Kind::Cylinder)[0]
        .spots
        .iter()
        .map(|s| s.gap_mm)
        .collect();
    near(
        gaps.iter().copied().fold(f64::INFINITY, f64::min),
        0.0,
        2e-3,
    );
    near(gaps.iter().copied().fold(0.0, f64::max), 0.2, 2e-3);
    // Seen from the pin the hole is the second's.
    let found = meetings(&b, &a, &Placement::translation(0.0, 0.0, -12.0));
    assert!(
        !of_kind(&found, Kind::Cylinder)[0]
            .about
            .unwrap()
            .first_has_hole
    );
    // Tilted by a degree it is in no line with the hole.
    let tilted = Placement::rotation_x(1.0) * Placement::translation(0.0, 0.0, 12.0);
    assert!(of_kind(&meetings(&a, &b, &tilted), Kind::Cylinder).is_empty());
}

#[test]
fn half_a_hole_closes_half_of_the_circle() {
    let block = plate(60.0, 60.0, 20.0);
    // The axis lies in the side of the block at y = -30: half of the hole is open.
    let half = cut(
        &block,
        &Shape::cylinder(&at(0.0, -30.0, -1.0), 10.0, 22.0).unwrap(),
    );
    let pin = Shape::cylinder(&at(0.0, 0.0, 0.0), 10.0, 20.0).unwrap();
    let found = meetings(
        &skin(&half),
        &skin(&pin),
        &Placement::translation(0.0, -30.0, 0.0),
    );
    let about = of_kind(&found, Kind::Cylinder)[0].about.unwrap();
    near(about.share, 0.5, 1e-6);
}

#[test]
fn a_roller_on_a_floor_and_a_ball_on_it() {
    let floor = skin(&plate(60.0, 60.0, 10.0));
    let roller = skin(&Shape::cylinder(&at(0.0, 0.0, 0.0), 5.0, 30.0).unwrap());
    // Lying along x, 0.05 mm above the floor.
    let lying = Placement::translation(-15.0, 0.0, 15.05)
        * Placement::rotation_about([0.0; 3], [0.0, 1.0, 0.0], 90.0).unwrap();
    let found = meetings(&floor, &roller, &lying);
    let line = of_kind(&found, Kind::Line);
    assert_eq!(line.len(), 1, "{found:?}");
    near(line[0].gap_mm, 0.05, 1e-9);
    let ends: Vec<f64> = line[0].spots.iter().map(|s| s.at[0]).collect();
    near((ends[0] - ends[1]).abs(), 30.0, 0.1);
    let ball = skin(&Shape::sphere(&at(0.0, 0.0, 0.0), 4.0).unwrap());
    let found = meetings(&floor, &ball, &Placement::translation(3.0, 2.0, 14.0));
    let point = of_kind(&found, Kind::Point);
    assert_eq!(point.len(), 1, "{found:?}");
    near(point[0].spots[0].at[0], 3.0, 1e-9);
    near(point[0].gap_mm, 0.0, 1e-9);
}
