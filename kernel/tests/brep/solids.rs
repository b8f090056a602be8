use core::f64::consts::PI;

use assemcad_kernel::Shape;
use assemcad_kernel::brep::{Corner, Topology};

use crate::common::*;

fn face_up(solid: &Shape) -> Shape {
    let mut faces = solid.parts(Topology::Face).unwrap();
    faces.sort_by(|a, b| a.center().unwrap()[2].total_cmp(&b.center().unwrap()[2]));
    faces.pop().unwrap()
}

#[test]
fn primitives_have_their_volumes() {
    let wedge = Shape::wedge(&WORLD, 6.0, 4.0, 6.0, 2.0, 2.0, 4.0, 4.0).unwrap();
    near(volume(&wedge), 4.0 / 3.0 * (36.0 + 4.0 + 12.0), 1e-12);
    let torus = Shape::torus(&WORLD, 5.0, 2.0).unwrap();
    near(volume(&torus), 2.0 * PI * PI * 5.0 * 4.0, 1e-12);
    let ball = Shape::sphere_part(&WORLD, 3.0, -90.0, 90.0, 360.0).unwrap();
    near(volume(&ball), 36.0 * PI, 1e-12);
    let dome = Shape::sphere_part(&WORLD, 3.0, 0.0, 90.0, 90.0).unwrap();
    near(volume(&dome), 36.0 * PI / 8.0, 1e-12);
    let slice = Shape::cylinder_part(&WORLD, 2.0, 5.0, 120.0).unwrap();
    near(volume(&slice), 20.0 * PI / 3.0, 1e-12);
    let cone = Shape::cone_part(&WORLD, 3.0, 0.0, 4.0, 180.0).unwrap();
    near(volume(&cone), 6.0 * PI, 1e-12);
    for solid in [wedge, torus, ball, dome, slice, cone] {
        sound(&solid);
    }
}

#[test]
fn fillets_and_chamfers_take_off_their_corners() {
    let solid = cuboid(10.0, 10.0, 10.0);
    let edges = solid.parts(Topology::Edge).unwrap();
    let upright: Vec<&Shape> = edges
        .iter()
        .filter(|e| (e.center().unwrap()[2] - 5.0).abs() < 1e-9)
        .collect();
    assert_eq!(upright.len(), 4);
    let round = solid.filleted(&upright, 2.0).unwrap();
    sound(&round);
    near(volume(&round), 1000.0 - (4.0 - PI) * 4.0 * 10.0, 1e-9);
    let cut = solid.chamfered(&upright, 2.0, None).unwrap();
    near(volume(&cut), 1000.0 - 4.0 * 2.0 * 10.0, 1e-9);
    let uneven = solid.chamfered(&upright, 2.0, Some(1.0)).unwrap();
    near(volume(&uneven), 1000.0 - 4.0 * 10.0, 1e-9);
    // A group too, one solid of two worked on.
    let other = cuboid_at([20.0, 0.0, 0.0], 5.0, 5.0, 5.0);
    let group = Shape::compound(&[&solid, &other]).unwrap();
    let both = group.filleted(&upright, 2.0).unwrap();
    assert_eq!(count(&both, Topology::Solid), 2);
    near(volume(&both), 1125.0 - (4.0 - PI) * 40.0, 1e-9);
}

#[test]
fn walls_inside_and_outside() {
    let solid = cuboid(10.0, 10.0, 10.0);
    let top = face_up(&solid);
    let inside = solid.hollowed(&[&top], -1.0, Corner::Arc).unwrap();
    near(volume(&inside), 1000.0 - 8.0 * 8.0 * 9.0, 1e-9);
    let outside = solid.hollowed(&[&top], 1.0, Corner::Intersection).unwrap();
    near(volume(&outside), 12.0 * 12.0 * 11.0 - 1000.0, 1e-9);
    // Rounded: slabs on five sides, quarter cylinders on eight edges, eighths of balls on four corners.
    let round = solid.hollowed(&[&top], 1.0, Corner::Arc).unwrap();
    near(
        volume(&round),
        500.0 + 8.0 * 10.0 * PI / 4.0 + 4.0 * (4.0 / 3.0 * PI) / 8.0,
        1e-9,
    );
    sound(&inside);
    sound(&outside);
    sound(&round);
}

#[test]
fn a_closed_cavity() {
    let solid = cuboid(10.0, 10.0, 10.0);
    let cavity = solid.hollowed(&[], -2.0, Corner::Arc).unwrap();
    near(volume(&cavity), 1000.0 - 216.0, 1e-9);
    assert_eq!(count(&cavity, Topology::Shell), 2);
    let around = solid.hollowed(&[], 2.0, Corner::Intersection).unwrap();
    near(volume(&around), 14.0 * 14.0 * 14.0 - 1000.0, 1e-9);
}

#[test]
fn booleans_of_many_and_of_groups() {
    let a = cuboid(10.0, 10.0, 10.0);
    let b = cuboid_at([5.0, 0.0, 0.0], 10.0, 10.0, 10.0);
    let c = cuboid_at([12.0, 0.0, 0.0], 10.0, 10.0, 10.0);
    let all = a.fused(&[&b, &c], false, None).unwrap();
    near(volume(&all), 2200.0, 1e-9);
    assert_eq!(all.topology().unwrap(), Topology::Compound);
    assert_eq!(count(&all, Topology::Solid), 1);
    assert!(count(&all, Topology::Face) > 6);
    let clean = all.cleaned().unwrap();
    assert_eq!(count(&clean, Topology::Face), 6);
    near(volume(&clean), 2200.0, 1e-9);

    // The children of a group are fused with each other.
    let group = Shape::compound(&[&a, &b]).unwrap();
    near(volume(&group), 2000.0, 1e-9);
    near(
        volume(&group.fused(&[], false, None).unwrap()),
        1500.0,
        1e-9,
    );
    let one = Shape::compound(&[&a]).unwrap();
    assert!(one.fused(&[], false, None).unwrap().same(&a));
    says(a.fused(&[], false, None), "nothing to do it with");

    near(volume(&a.without(&[&b], None).unwrap()), 500.0, 1e-9);
    near(volume(&a.shared(&[&b], None).unwrap()), 500.0, 1e-9);
    let nothing = a.shared(&[&c], None).unwrap();
    assert!(nothing.children().unwrap().is_empty());
    // Touching, glued.
    let beside = cuboid_at([10.0, 0.0, 0.0], 10.0, 10.0, 10.0);
    near(
        volume(&a.fused(&[&beside], true, None).unwrap()),
        2000.0,
        1e-9,
    );
    // A gap of a hundredth closes with a tolerance above it.
    let off = cuboid_at([10.01, 0.0, 0.0], 10.0, 10.0, 10.0);
    let apart = a.fused(&[&off], false, None).unwrap();
    assert_eq!(count(&apart, Topology::Solid), 2);
    let closed = a.fused(&[&off], false, Some(0.05)).unwrap();
    assert_eq!(count(&closed, Topology::Solid), 1);
}

#[test]
fn a_split_keeps_every_piece() {
    let solid = cuboid(10.0, 10.0, 10.0);
    let sheet = face(&rectangle(-1.0, -1.0, 11.0, 11.0, 4.0), &[]);
    let pieces = solid.split_by(&[&sheet]).unwrap();
    let mut volumes: Vec<f64> = pieces
        .parts(Topology::Solid)
        .unwrap()
        .iter()
        .map(volume)
        .collect();
    volumes.sort_by(f64::total_cmp);
    assert_eq!(volumes.len(), 2);
    near(volumes[0], 400.0, 1e-9);
    near(volumes[1], 600.0, 1e-9);
}

#[test]
fn operands_stay_as_they_are() {
    let a = cuboid(10.0, 10.0, 10.0);
    let b = cuboid_at([5.0, 5.0, 5.0], 10.0, 10.0, 10.0);
    let before = (a.to_bytes().unwrap(), b.to_bytes().unwrap());
    a.fused(&[&b], false, Some(1e-3)).unwrap();
    a.without(&[&b], None).unwrap().cleaned().unwrap();
    assert_eq!(before, (a.to_bytes().unwrap(), b.to_bytes().unwrap()));
}
