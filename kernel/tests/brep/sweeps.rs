use core::f64::consts::PI;

use assemcad_kernel::Shape;
use assemcad_kernel::brep::{Side, Sweep, Topology, Transition};
use assemcad_model::frame::Placement;

use crate::common::*;

fn along(path: &Shape) -> Sweep<'_> {
    Sweep {
        path,
        solid: true,
        frenet: false,
        transition: Transition::Transformed,
        normal: None,
        aux_spine: None,
    }
}

#[test]
fn prisms_with_holes() {
    let plate = face(
        &rectangle(0.0, 0.0, 10.0, 10.0, 0.0),
        &[&circle(5.0, 5.0, 0.0, 2.0)],
    );
    for vector in [[0.0, 0.0, 3.0], [0.0, 0.0, -3.0], [4.0, 0.0, 3.0]] {
        let solid = plate.extruded(vector, 0.0).unwrap();
        sound(&solid);
        // Area times height, however slanted.
        near(volume(&solid), (100.0 - 4.0 * PI) * 3.0, 1e-6);
    }
    let sheet = circle(0.0, 0.0, 0.0, 1.0)
        .extruded([0.0, 0.0, 2.0], 0.0)
        .unwrap();
    near(area(&sheet), 4.0 * PI, 1e-12);
}

#[test]
fn tapered_prisms_are_frusta() {
    let h = 5.0;
    let (up, down) = ([0.0, 0.0, h], [0.0, 0.0, -h]);
    for (taper, vector) in [(10.0, up), (-10.0, up), (10.0, down), (-10.0, down)] {
        let square = face(&rectangle(-5.0, -5.0, 5.0, 5.0, 0.0), &[]);
        let solid = square.extruded(vector, taper).unwrap();
        sound(&solid);
        let shift = h * libm::tan(f64::to_radians(taper));
        // Inwards: the far side is a smaller square, joined by mitred sides. Outwards: rounded ones
        // are not made either.
        let side = 10.0 - 2.0 * shift;
        let bounds = solid.extent().unwrap();
        near(bounds.size()[2], h, 1e-9);
        assert_eq!(bounds.min[2] < -1.0, vector[2] < 0.0);
        let expected = h / 3.0 * (100.0 + side * side + 10.0 * side);
        if taper > 0.0 {
            near(volume(&solid), expected, 1e-9);
        } else {
            // Rounded corners: the quarter cones take the place of the square pyramids.
            let s = -shift;
            let straight = 100.0 * h + 4.0 * 10.0 * s * h / 2.0;
            near(volume(&solid), straight + PI * s * s * h / 3.0, 1e-9);
        }
    }
    let disc = face(&circle(0.0, 0.0, 0.0, 4.0), &[]);
    let cone = disc.extruded(up, 20.0).unwrap();
    let top = 4.0 - h * libm::tan(f64::to_radians(20.0));
    near(
        volume(&cone),
        PI * h / 3.0 * (16.0 + 4.0 * top + top * top),
        1e-9,
    );
}

#[test]
fn extrusions_end_at_a_face_or_go_through_all() {
    let block = cuboid(10.0, 10.0, 10.0);
    let spot = face(&circle(5.0, 5.0, 10.0, 2.0), &[]);
    let through = Shape::extruded_until(&block, &spot, None, true, false, 0.0).unwrap();
    near(volume(&through), 1000.0 - 40.0 * PI, 1e-8);
    let shelf = cuboid_at([0.0, 0.0, 20.0], 10.0, 10.0, 5.0);
    let both = block.fused(&[&shelf], false, None).unwrap();
    let hits = both
        .faces_hit_by_line([5.0, 5.0, 10.0], [0.0, 0.0, 1.0], Side::Ahead)
        .unwrap();
    assert_eq!(hits.len(), 2);
    near3(hits[0].center().unwrap(), [5.0, 5.0, 20.0], 1e-9);
    let pillar = Shape::extruded_until(&both, &spot, Some(&hits[0]), false, true, 0.0).unwrap();
    near(volume(&pillar), 1500.0 + 40.0 * PI, 1e-9);
    assert_eq!(count(&pillar, Topology::Solid), 1);
}

#[test]
fn a_line_meets_faces_in_order() {
    let block = cuboid(10.0, 10.0, 10.0);
    let from = [5.0, 5.0, 10.0];
    let up = [0.0, 0.0, 1.0];
    assert!(
        block
            .faces_hit_by_line(from, up, Side::Ahead)
            .unwrap()
            .is_empty()
    );
    let below = block.faces_hit_by_line(from, up, Side::Behind).unwrap();
    assert_eq!(below.len(), 1);
    near3(below[0].center().unwrap(), [5.0, 5.0, 0.0], 1e-9);
    assert_eq!(
        block.faces_hit_by_line(from, up, Side::Both).unwrap().len(),
        2
    );
}

#[test]
fn a_twisted_prism_keeps_its_volume() {
    let plate = face(
        &rectangle(-5.0, -5.0, 5.0, 5.0, 0.0),
        &[&circle(2.0, 0.0, 0.0, 1.0)],
    );
    for angle in [90.0, -45.0] {
        let solid = plate.twisted([0.0; 3], [0.0, 0.0, 20.0], angle).unwrap();
        sound(&solid);
        // Cavalieri: every section has the area of the face.
        near(volume(&solid), (100.0 - PI) * 20.0, 1e-4);
    }
}

#[test]
fn the_twist_is_right_handed() {
    let off = face(&rectangle(4.0, -0.5, 6.0, 0.5, 0.0), &[]);
    let solid = off.twisted([0.0; 3], [0.0, 0.0, 10.0], 90.0).unwrap();
    let top = solid
        .parts(Topology::Face)
        .unwrap()
        .into_iter()
        .find(|f| f.center().unwrap()[2] > 9.9)
        .unwrap();
    near3(top.center().unwrap(), [0.0, 5.0, 10.0], 1e-3);
}

#[test]
fn revolutions_follow_pappus() {
    let plate = face(
        &rectangle(4.0, 0.0, 8.0, 3.0, 0.0),
        &[&circle(6.0, 1.5, 0.0, 1.0)],
    );
    for angle in [360.0, 90.0, -120.0] {
        let solid = plate.turned([0.0; 3], [0.0, 1.0, 0.0], angle).unwrap();
        assert!(solid.is_valid().unwrap());
        let turn = f64::to_radians(angle.abs());
        near(volume(&solid).abs(), (12.0 - PI) * 6.0 * turn, 1e-9);
        // A quarter turn about y carries +x to -z.
        if angle == 90.0 {
            assert!(solid.center().unwrap()[2] < 0.0);
        }
    }
}

#[test]
fn sweeps_follow_pappus() {
    let disc = face(&circle(0.0, 0.0, 0.0, 2.0), &[&circle(0.0, 0.0, 0.0, 1.0)]);
    // A quarter circle of radius 10 from the disc upwards, then bent over.
    let bend = Shape::tangent_arc_edge([0.0; 3], [0.0, 0.0, 1.0], [10.0, 0.0, 10.0]).unwrap();
    for frenet in [false, true] {
        let tube = disc
            .swept(&Sweep {
                frenet,
                ..along(&bend)
            })
            .unwrap();
        sound(&tube);
        near(volume(&tube), 3.0 * PI * 5.0 * PI, 1e-6);
    }
    let sheet = circle(0.0, 0.0, 0.0, 2.0)
        .swept(&Sweep {
            solid: false,
            ..along(&bend)
        })
        .unwrap();
    assert_eq!(count(&sheet, Topology::Solid), 0);
    near(area(&sheet), 4.0 * PI * 5.0 * PI, 1e-6);
}

#[test]
fn corners_of_a_path() {
    let square = face(&rectangle(-1.0, -1.0, 1.0, 1.0, 0.0), &[]);
    let path =
        Shape::polyline_wire(&[[0.0; 3], [0.0, 0.0, 10.0], [10.0, 0.0, 10.0]], false).unwrap();
    let mitred = square
        .swept(&Sweep {
            transition: Transition::Right,
            ..along(&path)
        })
        .unwrap();
    sound(&mitred);
    // Pappus holds for a mitre too: the centre line is 20 long.
    near(volume(&mitred), 80.0, 1e-9);
    let round = square
        .swept(&Sweep {
            transition: Transition::Round,
            ..along(&path)
        })
        .unwrap();
    sound(&round);
    // At the corner a quarter turn of the outer half, about the inner... about the corner's axis: the
    // mitre's outer square of 1 x 1 x 2 becomes a quarter cylinder.
    near(volume(&round), 80.0 - 2.0 + PI / 2.0, 1e-6);
}

#[test]
fn a_kept_normal_and_a_guide() {
    let square = face(&rectangle(-1.0, -1.0, 1.0, 1.0, 0.0), &[]);
    let path = Shape::line_edge([0.0; 3], [0.0, 0.0, 10.0]).unwrap();
    let kept = square
        .swept(&Sweep {
            normal: Some([0.0, 0.0, 1.0]),
            ..along(&path)
        })
        .unwrap();
    near(volume(&kept), 40.0, 1e-6);
    let guide = Shape::line_edge([5.0, 0.0, 0.0], [5.0, 0.0, 10.0]).unwrap();
    let led = square
        .swept(&Sweep {
            aux_spine: Some(&guide),
            ..along(&path)
        })
        .unwrap();
    sound(&led);
    near(volume(&led), 40.0, 1e-6);
}

#[test]
fn several_sections_make_one_sweep() {
    let path = Shape::line_edge([0.0; 3], [0.0, 0.0, 10.0]).unwrap();
    let (low, high) = (
        circle(0.0, 0.0, 0.0, 2.0),
        face(&circle(0.0, 0.0, 10.0, 2.0), &[]),
    );
    let solid = Shape::swept_multi(&[&low, &high], &along(&path)).unwrap();
    sound(&solid);
    near(volume(&solid), 40.0 * PI, 1e-6);
}

#[test]
fn ruled_lofts_are_frusta() {
    let (low, high) = (
        rectangle(-3.0, -3.0, 3.0, 3.0, 0.0),
        rectangle(-1.0, -1.0, 1.0, 1.0, 6.0),
    );
    let solid = Shape::lofted(&[&low, &high], true, true).unwrap();
    sound(&solid);
    near(volume(&solid), 2.0 * (36.0 + 4.0 + 12.0), 1e-9);
    let sheet = Shape::lofted(&[&low, &high], true, false).unwrap();
    assert_eq!(count(&sheet, Topology::Solid), 0);
    // Four trapezia of 6 and 2, whose height is the slant.
    near(area(&sheet), 4.0 * 4.0 * libm::hypot(6.0, 2.0), 1e-9);
    // Equal sections, smooth: a prism.
    let third = rectangle(-3.0, -3.0, 3.0, 3.0, 9.0);
    let same = rectangle(-3.0, -3.0, 3.0, 3.0, 4.0);
    let prism = Shape::lofted(&[&low, &same, &third], false, true).unwrap();
    near(volume(&prism), 36.0 * 9.0, 1e-6);
}

#[test]
fn a_thread_of_a_helix() {
    // A triangle carried along a helix: Pappus with the centroid's own path, roughly.
    let helix = Shape::helix_wire(3.0, 9.0, 10.0, &WORLD, 360.0, false).unwrap();
    let at = Placement::rotation_about([10.0, 0.0, 0.0], [1.0, 0.0, 0.0], 90.0).unwrap();
    let section = circle(10.0, 0.0, 0.0, 0.5).moved(&at).unwrap();
    let wire = section
        .swept(&Sweep {
            frenet: true,
            ..along(&helix)
        })
        .unwrap();
    sound(&wire);
    let turn = 2.0 * PI * 10.0;
    // The circle lies across y, and the helix leaves along y and a little up: sections across the
    // path are flatter by the cosine of the slope.
    let length = 3.0 * libm::hypot(turn, 3.0);
    let expected = 0.25 * PI * length * turn / libm::hypot(turn, 3.0);
    near(volume(&wire), expected, 1e-3);
}

#[test]
fn tapered_cuts_go_all_the_way_through() {
    let plate = cuboid_at([-20.0, -20.0, -5.0], 40.0, 40.0, 10.0);
    let square = face(&rectangle(-10.0, -10.0, 10.0, 10.0, 5.0), &[]);
    let shift = 10.0 * libm::tan(f64::to_radians(5.0));
    let inwards = Shape::extruded_until(&plate, &square, None, true, false, -5.0).unwrap();
    sound(&inwards);
    // A frustum; CadQuery's cutThruAll(taper=5) has this volume too.
    let side = 20.0 - 2.0 * shift;
    let frustum = 10.0 / 3.0 * (400.0 + side * side + 20.0 * side);
    near(volume(&inwards), 16000.0 - frustum, 1e-9);
    let outwards = Shape::extruded_until(&plate, &square, None, true, false, 5.0).unwrap();
    sound(&outwards);
    let rounded = 4000.0 + 80.0 * shift * 5.0 + PI * shift * shift * 10.0 / 3.0;
    near(volume(&outwards), 16000.0 - rounded, 1e-9);
    let cleaned = outwards.cleaned().unwrap();
    sound(&cleaned);
    near(volume(&cleaned), 16000.0 - rounded, 1e-9);
    // From the middle: narrower one way, wider the other.
    let middle = face(&rectangle(-10.0, -10.0, 10.0, 10.0, 0.0), &[]);
    let both = Shape::extruded_until(&plate, &middle, None, true, false, 5.0).unwrap();
    sound(&both);
    let half = shift / 2.0;
    let (low, high) = (
        2000.0 + 80.0 * half * 2.5 + PI * half * half * 5.0 / 3.0,
        5.0 / 3.0 * (400.0 + (20.0 - shift) * (20.0 - shift) + 20.0 * (20.0 - shift)),
    );
    near(volume(&both), 16000.0 - low - high, 1e-9);
}
