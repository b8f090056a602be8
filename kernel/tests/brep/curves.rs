use core::f64::consts::PI;

use assemcad_kernel::Shape;
use assemcad_kernel::brep::{Corner, Form, Spline, Topology};
use assemcad_model::frame::Placement;

use crate::common::*;

/// Ramanujan's second formula is good to 1e-10 for ellipses that are not flat.
fn ellipse_length(a: f64, b: f64) -> f64 {
    let h = ((a - b) / (a + b)) * ((a - b) / (a + b));
    PI * (a + b) * (1.0 + 3.0 * h / (10.0 + (4.0 - 3.0 * h).sqrt()))
}

#[test]
fn lines_and_arcs_have_their_lengths() {
    near(
        length(&Shape::line_edge([1.0, 2.0, 3.0], [4.0, 6.0, 3.0]).unwrap()),
        5.0,
        1e-12,
    );
    let half = Shape::arc_edge([2.0, 0.0, 0.0], [0.0, 2.0, 0.0], [-2.0, 0.0, 0.0]).unwrap();
    near(length(&half), 2.0 * PI, 1e-12);
    // Up from the origin to the right: a quarter of the circle about (3, 0, 0).
    let quarter = Shape::tangent_arc_edge([0.0; 3], [0.0, 7.0, 0.0], [3.0, 3.0, 0.0]).unwrap();
    near(length(&quarter), 1.5 * PI, 1e-12);
    near(quarter.radius().unwrap(), 3.0, 1e-12);
    near3(quarter.tangent_at(0.0).unwrap(), [0.0, 1.0, 0.0], 1e-12);
    near3(quarter.tangent_at(1.0).unwrap(), [1.0, 0.0, 0.0], 1e-12);
    let part = Shape::circle_arc_edge(&WORLD, 4.0, 30.0, 120.0).unwrap();
    near(length(&part), 2.0 * PI, 1e-12);
    near3(
        part.start_point().unwrap(),
        [4.0 * 0.75_f64.sqrt(), 2.0, 0.0],
        1e-12,
    );
    // Equal angles are the whole circle.
    near(
        length(&Shape::circle_arc_edge(&WORLD, 4.0, 360.0, 360.0).unwrap()),
        8.0 * PI,
        1e-12,
    );
}

#[test]
fn ellipses_may_be_taller_than_wide() {
    for (x, y) in [(4.0, 3.0), (3.0, 4.0)] {
        let edge = Shape::ellipse_edge(&WORLD, x, y, 0.0).unwrap();
        near(length(&edge), ellipse_length(4.0, 3.0), 1e-8);
        let size = edge.extent().unwrap().size();
        near3(size, [2.0 * x, 2.0 * y, 0.0], 1e-6);
        let turned = Shape::ellipse_edge(&WORLD, x, y, 90.0).unwrap();
        near3(
            turned.extent().unwrap().size(),
            [2.0 * y, 2.0 * x, 0.0],
            1e-6,
        );
        let quarter = Shape::ellipse_arc_edge(&WORLD, x, y, 0.0, 90.0, true).unwrap();
        near3(quarter.start_point().unwrap(), [x, 0.0, 0.0], 1e-12);
        near3(quarter.end_point().unwrap(), [0.0, y, 0.0], 1e-12);
        near(length(&quarter), ellipse_length(4.0, 3.0) / 4.0, 1e-8);
    }
}

fn spline<'a>(points: &'a [[f64; 3]]) -> Spline<'a> {
    Spline {
        points,
        tangents: None,
        periodic: false,
        parameters: None,
        scale: true,
        tolerance: 1e-6,
    }
}

#[test]
fn splines_pass_their_points() {
    let points = [[0.0; 3], [1.0, 1.0, 0.0], [2.0, 0.0, 0.0], [3.0, 1.0, 1.0]];
    let edge = Shape::spline_edge(&spline(&points)).unwrap();
    assert_eq!(edge.form().unwrap(), Form::BSpline);
    for point in points {
        let here = Shape::sphere_part(
            &Placement::translation(point[0], point[1], point[2]),
            0.01,
            -90.0,
            90.0,
            360.0,
        )
        .unwrap();
        assert!(edge.distance_to(&here).unwrap().0 < 1e-6);
    }
    let tangents = [Some([0.0, 1.0, 0.0]), Some([0.0, -1.0, 0.0])];
    let led = Shape::spline_edge(&Spline {
        tangents: Some(&tangents),
        ..spline(&points)
    })
    .unwrap();
    near3(led.tangent_at(0.0).unwrap(), [0.0, 1.0, 0.0], 1e-9);
    near3(led.tangent_at(1.0).unwrap(), [0.0, -1.0, 0.0], 1e-9);
    let some = [None, Some([1.0, 0.0, 0.0]), None, None];
    let held = Shape::spline_edge(&Spline {
        tangents: Some(&some),
        parameters: Some(&[0.0, 1.0, 2.0, 3.0]),
        ..spline(&points)
    })
    .unwrap();
    assert!(length(&held) > length(&Shape::line_edge(points[0], points[3]).unwrap()));
}

#[test]
fn a_spline_around_comes_back_to_its_start() {
    // Eight points of a circle: the cubic through them is within a thousandth of it.
    let points: Vec<[f64; 3]> = (0..8)
        .map(|i| {
            let (s, c) = libm::sincos(f64::from(i) * PI / 4.0);
            [10.0 * c, 10.0 * s, 0.0]
        })
        .collect();
    let ring = Shape::spline_edge(&Spline {
        periodic: true,
        ..spline(&points)
    })
    .unwrap();
    assert!(ring.is_closed_curve().unwrap());
    near(length(&ring), 20.0 * PI, 1e-3);
    let (out, back) = (ring.tangent_at(0.0).unwrap(), ring.tangent_at(1.0).unwrap());
    near3(out, back, 1e-6);
}

#[test]
fn approximated_and_bezier_curves() {
    let straight: Vec<[f64; 3]> = (0..5).map(|i| [f64::from(i), 0.0, 0.0]).collect();
    let edge = Shape::spline_approx_edge(&straight, 1e-3, 1, 6).unwrap();
    near(length(&edge), 4.0, 1e-6);
    // A quadratic Bezier curve is a piece of a parabola: y = x^2 from 0 to 1 has the poles below.
    let parabola = Shape::bezier_edge(&[[0.0; 3], [0.5, 0.0, 0.0], [1.0, 1.0, 0.0]]).unwrap();
    let root = 5.0_f64.sqrt();
    near(length(&parabola), root / 2.0 + libm::asinh(2.0) / 4.0, 1e-6);
    assert_eq!(parabola.form().unwrap(), Form::Bezier);
}

#[test]
fn wires_come_of_edges_in_any_order() {
    let a = Shape::line_edge([0.0; 3], [1.0, 0.0, 0.0]).unwrap();
    let b = Shape::line_edge([1.0, 0.0, 0.0], [1.0, 1.0, 0.0]).unwrap();
    let c = Shape::line_edge([1.0, 1.0, 0.0], [0.0; 3]).unwrap();
    let wire = Shape::wire(&[&a, &c, &b]).unwrap();
    assert!(wire.is_closed_curve().unwrap());
    near(length(&wire), 2.0 + 2.0_f64.sqrt(), 1e-12);
    let two = Shape::wire(&[&Shape::wire(&[&a, &b]).unwrap(), &c]).unwrap();
    assert_eq!(count(&two, Topology::Edge), 3);
    let far = Shape::line_edge([5.0, 0.0, 0.0], [6.0, 0.0, 0.0]).unwrap();
    says(Shape::wire(&[&a, &far]), "do not follow one another");
    let wires = Shape::connected_wires(&[&a, &far, &c, &b]).unwrap();
    assert_eq!(wires.len(), 2);
    assert_eq!(
        wires
            .iter()
            .filter(|w| w.is_closed_curve().unwrap())
            .count(),
        1
    );
}

#[test]
fn a_polyline_that_returns_to_its_start_is_closed() {
    let wire = Shape::polyline_wire(
        &[[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0; 3]],
        false,
    )
    .unwrap();
    assert!(wire.is_closed_curve().unwrap());
    assert_eq!(count(&wire, Topology::Vertex), 3);
}

#[test]
fn a_helix_is_as_long_as_its_unrolled_line() {
    let (pitch, height, radius) = (2.0, 7.0, 3.0);
    let turns = height / pitch;
    let expected = libm::hypot(2.0 * PI * radius * turns, height);
    for left in [false, true] {
        let wire = Shape::helix_wire(pitch, height, radius, &WORLD, 360.0, left).unwrap();
        near(length(&wire), expected, 1e-6);
        // Three turns and a half end on the other side.
        near3(wire.end_point().unwrap(), [-3.0, 0.0, 7.0], 1e-5);
        let early = wire.position_at(0.01).unwrap();
        assert_eq!(early[1] > 0.0, !left);
    }
    // On a cone of 30 degrees half angle the end is 7 mm along the slant.
    let cone = Shape::helix_wire(2.0, 8.0, 3.0, &WORLD, 30.0, false).unwrap();
    near3(
        cone.end_point().unwrap(),
        [3.0 + 8.0 * 0.5, 0.0, 8.0 * 0.75_f64.sqrt()],
        1e-5,
    );
}

#[test]
fn offsets_grow_by_the_corners() {
    let outline = rectangle(0.0, 0.0, 10.0, 6.0, 0.0);
    let round = outline.offset_2d(1.0, Corner::Arc).unwrap();
    assert_eq!(round.len(), 1);
    near(length(&round[0]), 32.0 + 2.0 * PI, 1e-9);
    let sharp = outline.offset_2d(1.0, Corner::Intersection).unwrap();
    near(length(&sharp[0]), 32.0 + 8.0, 1e-9);
    let inner = outline.offset_2d(-1.0, Corner::Arc).unwrap();
    near(length(&inner[0]), 32.0 - 8.0, 1e-9);
    let ring = circle(1.0, 2.0, 0.0, 4.0)
        .offset_2d(-1.5, Corner::Arc)
        .unwrap();
    near(length(&ring[0]), 5.0 * PI, 1e-9);
    // Some circles go down inside the kernel's own algorithm; one less than nothing is none.
    let small = circle(0.0, 0.0, 0.0, 1.0);
    let inside = small.offset_2d(-0.5, Corner::Arc).unwrap();
    near(length(&inside[0]), PI, 1e-12);
    assert!(small.offset_2d(-1.0, Corner::Arc).unwrap().is_empty());
}

#[test]
fn a_waist_offsets_to_two_wires() {
    // Two squares of 10 joined by a bridge 2 wide: 2 mm inwards there is nothing left of it. Where it
    // was the side of each square of 6 is two arcs of 30 degrees about the corners instead of 2 mm.
    let outline = Shape::polyline_wire(
        &[
            [0.0, 0.0, 0.0],
            [10.0, 0.0, 0.0],
            [10.0, 4.0, 0.0],
            [20.0, 4.0, 0.0],
            [20.0, 0.0, 0.0],
            [30.0, 0.0, 0.0],
            [30.0, 10.0, 0.0],
            [20.0, 10.0, 0.0],
            [20.0, 6.0, 0.0],
            [10.0, 6.0, 0.0],
            [10.0, 10.0, 0.0],
            [0.0, 10.0, 0.0],
        ],
        true,
    )
    .unwrap();
    let parts = outline.offset_2d(-2.0, Corner::Arc).unwrap();
    assert_eq!(parts.len(), 2);
    for part in parts {
        near(length(&part), 22.0 + 2.0 * 2.0 * PI / 6.0, 1e-6);
    }
}

#[test]
fn wires_nest_to_faces_with_holes() {
    let outer = rectangle(0.0, 0.0, 10.0, 10.0, 1.0);
    let hole = circle(3.0, 3.0, 1.0, 1.0);
    let second = circle(7.0, 7.0, 1.0, 2.0);
    let plate = face(&outer, &[&hole, &second]);
    assert_eq!(plate.topology().unwrap(), Topology::Face);
    near(area(&plate), 100.0 - 5.0 * PI, 1e-12);
    assert!(plate.is_valid().unwrap());
    near(length(&plate.outer_wire().unwrap()), 40.0, 1e-12);
    assert_eq!(plate.inner_wires().unwrap().len(), 2);
    // Beside each other they are faces of their own.
    let beside = rectangle(20.0, 0.0, 25.0, 5.0, 1.0);
    let faces = Shape::faces_from_wires(&[&outer, &second, &beside]).unwrap();
    let mut areas: Vec<f64> = faces.iter().map(area).collect();
    areas.sort_by(f64::total_cmp);
    assert_eq!(areas.len(), 2);
    near(areas[0], 25.0, 1e-12);
    near(areas[1], 100.0 - 4.0 * PI, 1e-12);
}
