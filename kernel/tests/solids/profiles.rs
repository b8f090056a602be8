//! Prisms and revolutions of profiles.

use core::f64::consts::PI;

use assemcad_kernel::Shape;
use assemcad_model::recipe::{Outline, Profile};

use super::common::{arc, line, near, near3, path, profile, rectangle, says, slanted};

/// A slot: a rectangle of 10 x 4 with half discs of radius 2 on both ends.
fn slot() -> Outline {
    path(
        [0.0, -2.0],
        vec![
            line(10.0, -2.0),
            arc([12.0, 0.0], [10.0, 2.0]),
            line(0.0, 2.0),
            arc([-2.0, 0.0], [0.0, -2.0]),
        ],
    )
}

#[test]
fn a_prism_with_arcs_and_a_hole() {
    let hole = Outline::Circle {
        center: [5.0, 0.0],
        radius: 1.0,
    };
    let p = Profile {
        holes: vec![hole],
        ..profile(slot())
    };
    let area = 40.0 + 4.0 * PI - PI;
    let wall = 20.0 + 4.0 * PI + 2.0 * PI;
    for length in [3.0, -3.0] {
        let shape = Shape::prism(&p, length).unwrap();
        assert!(!shape.has_locations().unwrap());
        let m = shape.mass().unwrap();
        near(m.volume, area * 3.0, 1e-12);
        near(m.area, 2.0 * area + wall * 3.0, 1e-12);
        near3(m.center, [5.0, 0.0, length / 2.0], 1e-11);
    }
    let slanted = Shape::prism(&Profile { at: slanted(), ..p }, 3.0).unwrap();
    near(slanted.mass().unwrap().volume, area * 3.0, 1e-11);
}

#[test]
fn the_sense_of_an_outline_does_not_matter() {
    let clockwise = path(
        [0.0, 0.0],
        vec![line(0.0, 3.0), line(4.0, 3.0), line(4.0, 0.0)],
    );
    let hole = path(
        [1.0, 1.0],
        vec![line(2.0, 1.0), line(2.0, 2.0), line(1.0, 2.0)],
    );
    let p = Profile {
        holes: vec![hole],
        ..profile(clockwise)
    };
    near(
        Shape::prism(&p, 2.0).unwrap().mass().unwrap().volume,
        22.0,
        1e-13,
    );
}

#[test]
fn a_revolution_obeys_pappus() {
    // A rectangle of 2 x 3 whose centroid is 5 from the axis.
    let p = profile(rectangle(4.0, 1.0, 2.0, 3.0));
    for (deg, side) in [(360.0, 0.0), (90.0, 12.0), (213.0, 12.0)] {
        let shape = Shape::revolve(&p, [0.0, 0.0], [0.0, 1.0], deg).unwrap();
        let turn = deg / 360.0;
        let m = shape.mass().unwrap();
        near(m.volume, 6.0 * 10.0 * PI * turn, 1e-12);
        near(m.area, 10.0 * 10.0 * PI * turn + side, 1e-12);
    }
    // The axis reversed turns the other way and gives as much.
    let back = Shape::revolve(&p, [0.0, 0.0], [0.0, -2.0], 90.0).unwrap();
    near(back.mass().unwrap().volume, 15.0 * PI, 1e-12);
    // Right-handed about +y from the x-y plane: towards -z.
    let quarter = Shape::revolve(&p, [0.0, 0.0], [0.0, 1.0], 90.0)
        .unwrap()
        .bounds()
        .unwrap();
    near3(quarter.min, [0.0, 1.0, -6.0], 1e-6);
    near3(quarter.max, [6.0, 4.0, 0.0], 1e-6);
}

#[test]
fn a_torus_and_a_ball() {
    let ring = profile(Outline::Circle {
        center: [5.0, 0.0],
        radius: 2.0,
    });
    let torus = Shape::revolve(&ring, [0.0, 0.0], [0.0, 1.0], 360.0).unwrap();
    near(
        torus.mass().unwrap().volume,
        2.0 * PI * PI * 5.0 * 4.0,
        1e-10,
    );
    near3(torus.bounds().unwrap().max, [7.0, 2.0, 7.0], 1e-6);
    let half = profile(path([0.0, -3.0], vec![arc([3.0, 0.0], [0.0, 3.0])]));
    let ball = Shape::revolve(&half, [0.0, 0.0], [0.0, 1.0], 360.0).unwrap();
    near(ball.mass().unwrap().volume, 36.0 * PI, 1e-10);
}

#[test]
fn bad_profiles_are_refused_in_words() {
    let bow = path(
        [0.0, 0.0],
        vec![line(4.0, 4.0), line(4.0, 0.0), line(0.0, 3.0)],
    );
    let flat = path([0.0, 0.0], vec![line(4.0, 0.0)]);
    let straight = path(
        [0.0, 0.0],
        vec![arc([1.0, 0.0], [2.0, 0.0]), line(0.0, 2.0)],
    );
    let twice = path(
        [0.0, 0.0],
        vec![line(0.0, 0.0), line(1.0, 0.0), line(0.0, 1.0)],
    );
    for (outline, words) in [
        (bow, "crosses itself"),
        (flat, "encloses no area"),
        (straight, "three points of one line"),
        (twice, "has no length"),
    ] {
        says(&Shape::prism(&profile(outline), 1.0).unwrap_err(), &[words]);
    }
    let outside = Outline::Circle {
        center: [20.0, 0.0],
        radius: 1.0,
    };
    let p = Profile {
        holes: vec![outside],
        ..profile(slot())
    };
    says(
        &Shape::prism(&p, 1.0).unwrap_err(),
        &["a hole lies outside"],
    );
    let across = Outline::Circle {
        center: [5.0, 2.0],
        radius: 1.0,
    };
    let p = Profile {
        holes: vec![across],
        ..profile(slot())
    };
    says(&Shape::prism(&p, 1.0).unwrap_err(), &["cross"]);
}

#[test]
fn a_profile_across_the_axis_is_refused() {
    let p = profile(rectangle(-1.0, 0.0, 3.0, 1.0));
    let error = Shape::revolve(&p, [0.0, 0.0], [0.0, 1.0], 360.0).unwrap_err();
    says(&error, &["crosses the axis", "1 mm", "2 mm"]);
    // Only the belly of the arc reaches across.
    let belly = profile(path(
        [1.0, -1.0],
        vec![
            line(2.0, 0.0),
            line(1.0, 1.0),
            arc([-0.5, 0.0], [1.0, -1.0]),
        ],
    ));
    let error = Shape::revolve(&belly, [0.0, 0.0], [0.0, 1.0], 360.0).unwrap_err();
    says(&error, &["crosses the axis", "0.5"]);
    let good = profile(rectangle(0.0, 0.0, 2.0, 1.0));
    for deg in [0.0, -5.0, 361.0, f64::NAN] {
        assert!(Shape::revolve(&good, [0.0, 0.0], [0.0, 1.0], deg).is_err());
    }
    let solid = Shape::revolve(&good, [0.0, 0.0], [0.0, 1.0], 360.0).unwrap();
    near(solid.mass().unwrap().volume, 4.0 * PI, 1e-12);
}
