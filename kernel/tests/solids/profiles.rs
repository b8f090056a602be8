//! Prisms and revolutions of outlines.

use core::f64::consts::PI;

use assemcad_kernel::Shape;

use super::common::{circle, near, near3, polygon, prism, slanted};

const Y: [f64; 3] = [0.0, 1.0, 0.0];

/// A slot: a rectangle of 10 x 4 with half discs of radius 2 on both ends.
fn slot() -> Shape {
    let line = |a: [f64; 2], b: [f64; 2]| Shape::line_edge([a[0], a[1], 0.0], [b[0], b[1], 0.0]);
    let arc = |x: f64, via: f64, sign: f64| {
        Shape::arc_edge([x, -2.0 * sign, 0.0], [via, 0.0, 0.0], [x, 2.0 * sign, 0.0])
    };
    let edges = [
        line([0.0, -2.0], [10.0, -2.0]).unwrap(),
        arc(10.0, 12.0, 1.0).unwrap(),
        line([10.0, 2.0], [0.0, 2.0]).unwrap(),
        arc(0.0, -2.0, -1.0).unwrap(),
    ];
    Shape::wire(&edges.iter().collect::<Vec<_>>()).unwrap()
}

#[test]
fn a_prism_with_arcs_and_a_hole() {
    let area = 40.0 + 4.0 * PI - PI;
    let wall = 20.0 + 4.0 * PI + 2.0 * PI;
    for length in [3.0, -3.0] {
        let shape = prism(&slot(), &[&circle(5.0, 0.0, 1.0)], length);
        let m = shape.mass().unwrap();
        near(m.volume, area * 3.0, 1e-12);
        near(m.area, 2.0 * area + wall * 3.0, 1e-12);
        near3(m.center, [5.0, 0.0, length / 2.0], 1e-11);
    }
    let upright = prism(&slot(), &[&circle(5.0, 0.0, 1.0)], 3.0);
    let there = slanted().placement().unwrap();
    let slanted = upright.placed(&there).unwrap();
    assert!(!slanted.has_locations().unwrap());
    near(slanted.mass().unwrap().volume, area * 3.0, 1e-11);
}

#[test]
fn the_sense_of_an_outline_does_not_matter() {
    let clockwise = polygon(&[[0.0, 0.0], [0.0, 3.0], [4.0, 3.0], [4.0, 0.0]]);
    let hole = polygon(&[[1.0, 1.0], [2.0, 1.0], [2.0, 2.0], [1.0, 2.0]]);
    let shape = prism(&clockwise, &[&hole], 2.0);
    near(shape.mass().unwrap().volume, 22.0, 1e-13);
}

#[test]
fn a_revolution_obeys_pappus() {
    // A rectangle of 2 x 3 whose centroid is 5 from the axis.
    let outline = polygon(&[[4.0, 1.0], [6.0, 1.0], [6.0, 4.0], [4.0, 4.0]]);
    let face = Shape::face(&outline, &[]).unwrap();
    for (deg, side) in [(360.0, 0.0), (90.0, 12.0), (213.0, 12.0)] {
        let shape = face.turned([0.0; 3], Y, deg).unwrap();
        let turn = deg / 360.0;
        let m = shape.mass().unwrap();
        near(m.volume, 6.0 * 10.0 * PI * turn, 1e-12);
        near(m.area, 10.0 * 10.0 * PI * turn + side, 1e-12);
    }
    // Right-handed about +y from the x-y plane: towards -z.
    let quarter = face.turned([0.0; 3], Y, 90.0).unwrap().bounds().unwrap();
    near3(quarter.min, [0.0, 1.0, -6.0], 1e-6);
    near3(quarter.max, [6.0, 4.0, 0.0], 1e-6);
}

#[test]
fn a_torus_and_a_ball() {
    let ring = Shape::face(&circle(5.0, 0.0, 2.0), &[]).unwrap();
    let torus = ring.turned([0.0; 3], Y, 360.0).unwrap();
    near(
        torus.mass().unwrap().volume,
        2.0 * PI * PI * 5.0 * 4.0,
        1e-10,
    );
    near3(torus.bounds().unwrap().max, [7.0, 2.0, 7.0], 1e-6);
    let arc = Shape::arc_edge([0.0, -3.0, 0.0], [3.0, 0.0, 0.0], [0.0, 3.0, 0.0]).unwrap();
    let axis = Shape::line_edge([0.0, 3.0, 0.0], [0.0, -3.0, 0.0]).unwrap();
    let half = Shape::face(&Shape::wire(&[&arc, &axis]).unwrap(), &[]).unwrap();
    let ball = half.turned([0.0; 3], Y, 360.0).unwrap();
    near(ball.mass().unwrap().volume, 36.0 * PI, 1e-10);
}
