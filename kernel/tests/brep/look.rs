use core::f64::consts::PI;

use assemcad_kernel::Shape;
use assemcad_kernel::brep::{Form, Topology};
use assemcad_model::frame::Placement;

use crate::common::*;

#[test]
fn a_box_has_six_faces_twelve_edges_eight_corners() {
    let solid = cuboid(10.0, 20.0, 30.0);
    for (kind, number) in [
        (Topology::Solid, 1),
        (Topology::Shell, 1),
        (Topology::Face, 6),
        (Topology::Wire, 6),
        (Topology::Edge, 12),
        (Topology::Vertex, 8),
        (Topology::Compound, 0),
    ] {
        assert_eq!(count(&solid, kind), number, "{kind:?}");
    }
    assert_eq!(solid.topology().unwrap(), Topology::Solid);
    assert!(solid.parts(Topology::Solid).unwrap()[0].same(&solid));
}

#[test]
fn the_poles_of_a_sphere_are_no_edges() {
    let ball = Shape::sphere_part(&WORLD, 5.0, -90.0, 90.0, 360.0).unwrap();
    assert_eq!(count(&ball, Topology::Face), 1);
    assert_eq!(count(&ball, Topology::Edge), 1);
    assert_eq!(count(&ball, Topology::Vertex), 2);
}

#[test]
fn an_edge_of_a_box_is_held_by_two_faces_and_a_corner_by_three_edges() {
    let solid = cuboid(1.0, 2.0, 3.0);
    for edge in solid.parts(Topology::Edge).unwrap() {
        assert_eq!(solid.ancestors(&edge, Topology::Face).unwrap().len(), 2);
    }
    for corner in solid.parts(Topology::Vertex).unwrap() {
        assert_eq!(solid.ancestors(&corner, Topology::Edge).unwrap().len(), 3);
        assert_eq!(solid.ancestors(&corner, Topology::Solid).unwrap().len(), 1);
    }
    // The seam is in the side twice, and the side is listed once.
    let round = Shape::cylinder_part(&WORLD, 2.0, 5.0, 360.0).unwrap();
    let holders: Vec<usize> = round
        .parts(Topology::Edge)
        .unwrap()
        .iter()
        .map(|e| round.ancestors(e, Topology::Face).unwrap().len())
        .collect();
    assert_eq!(holders.iter().sum::<usize>(), 5);
    let other = cuboid(1.0, 1.0, 1.0);
    let edge = other.parts(Topology::Edge).unwrap().remove(0);
    says(
        solid.ancestors(&edge, Topology::Face),
        "no part of the other",
    );
}

#[test]
fn groups_keep_their_children_in_order() {
    let (a, b) = (cuboid(1.0, 1.0, 1.0), circle(0.0, 0.0, 0.0, 1.0));
    let group = Shape::compound(&[&b, &a]).unwrap();
    let children = group.children().unwrap();
    assert_eq!(group.topology().unwrap(), Topology::Compound);
    assert!(children[0].same(&b) && children[1].same(&a) && !a.same(&b));
    assert!(a.try_clone().unwrap().same(&a));
    assert!(Shape::compound(&[]).unwrap().children().unwrap().is_empty());
}

#[test]
fn the_corners_of_a_wire_come_in_its_order() {
    let open = Shape::polyline_wire(&[[3.0, 0.0, 0.0], [0.0; 3], [0.0, 4.0, 0.0]], false).unwrap();
    let at: Vec<[f64; 3]> = open
        .parts(Topology::Vertex)
        .unwrap()
        .iter()
        .map(|v| v.center().unwrap())
        .collect();
    assert_eq!(at, [[3.0, 0.0, 0.0], [0.0; 3], [0.0, 4.0, 0.0]]);
    assert_eq!(
        count(&rectangle(0.0, 0.0, 1.0, 1.0, 0.0), Topology::Vertex),
        4
    );
}

#[test]
fn forms_are_those_of_the_geometry() {
    let frustum = Shape::cone_part(&WORLD, 3.0, 1.0, 4.0, 360.0).unwrap();
    let mut forms: Vec<&str> = frustum
        .parts(Topology::Face)
        .unwrap()
        .iter()
        .map(|f| f.form().unwrap().name())
        .collect();
    forms.sort_unstable();
    assert_eq!(forms, ["CONE", "PLANE", "PLANE"]);
    assert_eq!(
        Shape::circle_edge(&WORLD, 1.0).unwrap().form().unwrap(),
        Form::Circle
    );
    assert_eq!(circle(0.0, 0.0, 0.0, 1.0).form().unwrap(), Form::Wire);
    assert_eq!(frustum.form().unwrap(), Form::Solid);
    let torus = Shape::torus(&WORLD, 5.0, 1.0).unwrap();
    assert_eq!(
        torus.parts(Topology::Face).unwrap()[0].form().unwrap(),
        Form::Torus
    );
}

#[test]
fn centres_weigh_by_length_area_or_volume() {
    // A right angle of 3 and 4: the middles of both sides, weighed by their lengths.
    let angle = Shape::polyline_wire(&[[3.0, 0.0, 0.0], [0.0; 3], [0.0, 4.0, 0.0]], false).unwrap();
    near3(
        angle.center().unwrap(),
        [3.0 * 1.5 / 7.0, 4.0 * 2.0 / 7.0, 0.0],
        1e-12,
    );
    // The triangle's centroid is the mean of its corners.
    let outline =
        Shape::polyline_wire(&[[3.0, 0.0, 0.0], [0.0; 3], [0.0, 4.0, 0.0]], true).unwrap();
    near3(
        face(&outline, &[]).center().unwrap(),
        [1.0, 4.0 / 3.0, 0.0],
        1e-12,
    );
    let (small, large) = (
        cuboid(2.0, 2.0, 2.0),
        cuboid_at([10.0, 0.0, 0.0], 2.0, 2.0, 4.0),
    );
    // Volumes 8 and 16, centres (1, 1, 1) and (11, 1, 2).
    let middle = [(8.0 + 16.0 * 11.0) / 24.0, 1.0, (8.0 + 32.0) / 24.0];
    near3(
        Shape::combined_center(&[&small, &large]).unwrap(),
        middle,
        1e-12,
    );
    let group = Shape::compound(&[&small, &large]).unwrap();
    near3(group.center().unwrap(), middle, 1e-12);
    near3(group.box_center().unwrap(), [6.0, 1.0, 2.0], 1e-9);
    let corner = &small.parts(Topology::Vertex).unwrap()[0];
    let at = corner.center().unwrap();
    let bounds = corner.extent().unwrap();
    near3(bounds.min, at, 1e-12);
    near3(bounds.max, at, 1e-12);
    says(
        Shape::compound(&[corner]).unwrap().center(),
        "a group of points",
    );
}

#[test]
fn normals_point_out_of_the_material() {
    let solid = cuboid(2.0, 4.0, 6.0);
    for side in solid.parts(Topology::Face).unwrap() {
        let (n, c) = (side.normal_at(None).unwrap(), side.center().unwrap());
        // From the middle of the box to the middle of the side.
        let out: f64 = n
            .iter()
            .zip(c)
            .zip([1.0, 2.0, 3.0])
            .map(|((n, c), m)| n * (c - m))
            .sum();
        assert!(out > 0.9);
        let plane = side.plane_of().unwrap();
        let z: [f64; 3] = plane.axes()[2].into();
        let along: f64 = n.iter().zip(z).map(|(a, b)| a * b).sum();
        near(along.abs(), 1.0, 1e-12);
    }
    let round = Shape::cylinder_part(&WORLD, 2.0, 5.0, 360.0).unwrap();
    let side = round
        .parts(Topology::Face)
        .unwrap()
        .into_iter()
        .find(|f| f.form().unwrap() == Form::Cylinder)
        .unwrap();
    near3(
        side.normal_at(Some([0.0, 7.0, 1.0])).unwrap(),
        [0.0, 1.0, 0.0],
        1e-9,
    );
    says(side.plane_of(), "not flat");
    let slanted = Placement::rotation_about([0.0; 3], [1.0, 0.0, 0.0], 90.0).unwrap();
    let wire = circle(0.0, 0.0, 0.0, 1.0).moved(&slanted).unwrap();
    let [x, y, z] = wire.normal_at(None).unwrap();
    near3([x, y.abs(), z], [0.0, 1.0, 0.0], 1e-12);
    let line = Shape::line_edge([0.0; 3], [1.0, 0.0, 0.0]).unwrap();
    says(line.normal_at(None), "one plane only");
}

#[test]
fn curves_are_walked_by_length() {
    let path = Shape::polyline_wire(&[[0.0; 3], [3.0, 0.0, 0.0], [3.0, 1.0, 0.0]], false).unwrap();
    near3(path.position_at(0.5).unwrap(), [2.0, 0.0, 0.0], 1e-9);
    near3(path.tangent_at(0.9).unwrap(), [0.0, 1.0, 0.0], 1e-9);
    near3(path.start_point().unwrap(), [0.0; 3], 0.0);
    near3(path.end_point().unwrap(), [3.0, 1.0, 0.0], 0.0);
    assert!(!path.is_closed_curve().unwrap());
    let ring = circle(0.0, 0.0, 0.0, 2.0);
    assert!(ring.is_closed_curve().unwrap());
    near3(ring.position_at(0.25).unwrap(), [0.0, 2.0, 0.0], 1e-9);
    near3(ring.tangent_at(0.0).unwrap(), [0.0, 1.0, 0.0], 1e-12);
    near(ring.radius().unwrap(), 2.0, 1e-15);
    says(path.radius(), "no circle");
    says(path.tangent_at(1.5), "between 0 and 1");
}

#[test]
fn what_is_moved_shares_its_geometry_and_what_is_baked_has_no_location() {
    let solid = cuboid(1.0, 2.0, 3.0);
    let there = Placement::rotation_about([1.0, 0.0, 0.0], [1.0, 1.0, 0.5], 33.0).unwrap();
    let moved = solid.moved(&there).unwrap();
    assert!(moved.has_locations().unwrap());
    let back = moved.moved(&there.inverse()).unwrap();
    near3(back.center().unwrap(), [0.5, 1.0, 1.5], 1e-12);
    let baked = moved.baked().unwrap();
    assert!(!baked.has_locations().unwrap());
    sound(&baked);
    near(volume(&baked), 6.0, 1e-12);
    near3(baked.center().unwrap(), there.point([0.5, 1.0, 1.5]), 1e-12);
    // And within groups that were moved themselves.
    let round = Shape::torus(&WORLD, 5.0, 1.0).unwrap();
    let inner = Shape::compound(&[&moved, &round]).unwrap();
    let outer = Shape::compound(&[&inner.moved(&there).unwrap(), &round]).unwrap();
    let plain = outer.moved(&there).unwrap().baked().unwrap();
    assert!(!plain.has_locations().unwrap() && plain.is_valid().unwrap());
    near(volume(&plain), 6.0 + 2.0 * 10.0 * PI * PI, 1e-9);
    let first = &plain.parts(Topology::Solid).unwrap()[0];
    let there3 = there.then_inner(&there.then_inner(&there));
    near3(first.center().unwrap(), there3.point([0.5, 1.0, 1.5]), 1e-9);
}

#[test]
fn a_mirror_image_lies_behind_the_mirror() {
    let image = cuboid(1.0, 2.0, 3.0)
        .mirrored([5.0, 0.0, 0.0], [2.0, 0.0, 0.0])
        .unwrap();
    sound(&image);
    near3(image.center().unwrap(), [9.5, 1.0, 1.5], 1e-12);
    near(volume(&image), 6.0, 1e-12);
}

#[test]
fn distances_are_the_shortest() {
    let ball = Shape::sphere_part(&WORLD, 1.0, -90.0, 90.0, 360.0).unwrap();
    let (gap, on_ball, on_box) = ball
        .distance_to(&cuboid_at([5.0, -1.0, -1.0], 2.0, 2.0, 2.0))
        .unwrap();
    near(gap, 4.0, 1e-9);
    near3(on_ball, [1.0, 0.0, 0.0], 1e-5);
    near(on_box[0], 5.0, 1e-9);
}

#[test]
fn measures_are_those_of_the_kind() {
    near(length(&circle(0.0, 0.0, 0.0, 3.0)), 6.0 * PI, 1e-12);
    let ring = face(&circle(0.0, 0.0, 0.0, 3.0), &[&circle(0.5, 0.0, 0.0, 1.0)]);
    let found = ring.measure().unwrap();
    near(found.area, 8.0 * PI, 1e-12);
    assert_eq!((found.length, found.volume), (0.0, 0.0));
}
