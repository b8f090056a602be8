//! Faces and edges: kinds, places, normals.

use core::f64::consts::PI;

use assemcad_kernel::Shape;
use assemcad_kernel::facts::{Curve, Face, Surface, Turn};
use assemcad_model::frame::Frame;

use super::common::{Two, cuboid, cylinder, edges_where, near, near3, slanted};

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

#[test]
fn normals_of_a_box_point_outward() {
    let b = cuboid([1.0, 2.0, 3.0], [4.0, 5.0, 6.0]);
    let center = b.mass().unwrap().center;
    let faces = b.faces().unwrap();
    assert_eq!(faces.len(), 6);
    for face in &faces {
        let Surface::Plane { normal } = face.surface else {
            panic!("{face:?}")
        };
        let out = [0, 1, 2].map(|i| face.origin[i] - center[i]);
        // From the centre of the box, a face's centroid lies along its normal.
        near(dot(out, normal), dot(out, out).sqrt(), 1e-12);
    }
    near(faces.iter().map(|f| f.area).sum(), 148.0, 1e-12);
}

#[test]
fn a_hole_and_a_pin() {
    let plate = cuboid([0.0; 3], [10.0, 10.0, 2.0]).cut(&cylinder([4.0, 5.0, -1.0], 2.0, 4.0));
    let pin = cylinder([4.0, 5.0, 0.0], 2.0, 2.0);
    let round = |faces: Vec<Face>| -> Face {
        faces
            .into_iter()
            .find(|f| matches!(f.surface, Surface::Cylinder { .. }))
            .unwrap()
    };
    for (shape, hole) in [(plate, true), (pin, false)] {
        let face = round(shape.faces().unwrap());
        let Surface::Cylinder {
            axis,
            radius,
            inward,
            span_deg,
            range,
        } = face.surface
        else {
            panic!("{face:?}")
        };
        assert_eq!(inward, hole);
        near(radius, 2.0, 1e-14);
        near(axis[2].abs(), 1.0, 1e-14);
        near(span_deg, 360.0, 1e-12);
        near3(face.origin, [4.0, 5.0, 1.0], 1e-9);
        near(range[0], -1.0, 1e-9);
        near(range[1], 1.0, 1e-9);
        near(face.area, 8.0 * PI, 1e-12);
        for plane in shape.faces().unwrap() {
            if let Surface::Plane { normal } = plane.surface {
                let beyond = [0, 1, 2].map(|i| plane.origin[i] + normal[i] * 100.0);
                let inside = shape.bounds().unwrap();
                // Far along an outward normal one has left the box on that side.
                assert!((0..3).any(|i| beyond[i] > inside.max[i] || beyond[i] < inside.min[i]));
            }
        }
    }
}

#[test]
fn pockets_have_normals_into_the_pocket() {
    let b = cuboid([0.0; 3], [10.0; 3]).cut(&cuboid([3.0, 3.0, 6.0], [4.0, 4.0, 10.0]));
    let floor = b
        .faces()
        .unwrap()
        .into_iter()
        .find(|f| (f.origin[2] - 6.0).abs() < 1e-9)
        .unwrap();
    let Surface::Plane { normal } = floor.surface else {
        panic!("{floor:?}")
    };
    near3(normal, [0.0, 0.0, 1.0], 1e-14);
    near3(floor.origin, [5.0, 5.0, 6.0], 1e-12);
    let turns = |t: Turn| b.edges().unwrap().iter().filter(|e| e.turn == t).count();
    // Twelve of the box, four of the rim; four at the floor, four in the corners.
    assert_eq!((turns(Turn::Convex), turns(Turn::Concave)), (16, 8));
}

#[test]
fn cones_spheres_and_tori() {
    let cone = Shape::cone(&slanted(), 4.0, 1.0, 3.0).unwrap();
    let face = cone
        .faces()
        .unwrap()
        .into_iter()
        .find(|f| !matches!(f.surface, Surface::Plane { .. }));
    let Surface::Cone {
        axis,
        radius,
        half_angle_deg,
        inward,
        range,
        ..
    } = face.unwrap().surface
    else {
        panic!("no cone")
    };
    assert!(!inward);
    near(half_angle_deg, 45.0, 1e-12);
    near(dot(axis, slanted().z).abs(), 1.0, 1e-12);
    near(range[1] - range[0], 3.0, 1e-9);
    assert!(radius > 1.0 && radius < 4.0);

    let ball = Shape::sphere(&Frame::WORLD, 2.0).unwrap();
    let hollow = cuboid([-5.0; 3], [10.0; 3]).cut(&ball);
    for (shape, around) in [(ball, false), (hollow, true)] {
        assert!(shape.faces().unwrap().iter().any(|f| matches!(
            f.surface,
            Surface::Sphere { radius, inward } if (radius - 2.0).abs() < 1e-12 && inward == around
        )));
    }
    let pin = cylinder([0.0; 3], 5.0, 10.0);
    let top = edges_where(&pin, |[_, _, z]| (z - 10.0).abs() < 1e-9);
    let round = pin.filleted(&top.iter().collect::<Vec<_>>(), 1.0).unwrap();
    assert!(round.faces().unwrap().iter().any(|f| matches!(
        f.surface,
        Surface::Torus { radius, tube_radius, inward: false, .. }
            if (radius - 4.0).abs() < 1e-9 && (tube_radius - 1.0).abs() < 1e-9
    )));
}

#[test]
fn edges_know_their_curves() {
    let c = cylinder([1.0, 2.0, 3.0], 5.0, 10.0);
    let edges = c.edges().unwrap();
    assert_eq!(edges.len(), 3);
    for edge in edges {
        match edge.curve {
            Curve::Circle {
                center,
                radius,
                axis,
            } => {
                near(edge.length, 10.0 * PI, 1e-9);
                near(radius, 5.0, 1e-14);
                near(axis[2].abs(), 1.0, 1e-14);
                near3([center[0], center[1], 0.0], [1.0, 2.0, 0.0], 1e-12);
                near3(edge.start, edge.end, 1e-9);
                assert_eq!(edge.turn, Turn::Convex);
            }
            Curve::Line => {
                near(edge.length, 10.0, 1e-12);
                near(edge.tangent[2].abs(), 1.0, 1e-12);
                assert_eq!(edge.turn, Turn::Seam);
            }
            other => panic!("{other:?}"),
        }
        assert_eq!(edge.samples.len(), 9);
    }
}
