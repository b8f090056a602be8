//! Areas over which placed solids touch, against closed forms.

use core::f64::consts::PI;

use assemcad_kernel::Shape;
use assemcad_kernel::contact::{Where, touch};
use assemcad_model::frame::Placement;

use super::common::{Two, cuboid, cylinder, near, slanted};

const HERE: Placement = Placement::IDENTITY;

/// The common area of two solids in a place, as they are and moved together.
fn area(a: &Shape, b: &Shape, at_b: &Placement, place: &Where) -> f64 {
    let found = touch(a, &HERE, b, at_b, place).unwrap();
    assert!(found.warnings.is_empty(), "{found:?}");
    let there = slanted().placement().unwrap();
    let moved = match *place {
        Where::Plane { point, normal } => Where::Plane {
            point: there.point(point),
            normal: there.direction(normal),
        },
        Where::Axis { point, direction } => Where::Axis {
            point: there.point(point),
            direction: there.direction(direction),
        },
    };
    let again = touch(a, &there, b, &(there * *at_b), &moved).unwrap();
    near(again.area, found.area, 1e-6);
    // The order of the two does not matter.
    let other = touch(b, at_b, a, &HERE, place).unwrap();
    near(other.area, found.area, 1e-6);
    found.area
}

#[test]
fn boxes_touch_over_an_area_or_not_at_all() {
    let base = cuboid([0.0; 3], [20.0, 20.0, 10.0]);
    let top = cuboid([0.0; 3], [10.0, 10.0, 5.0]);
    let place = Where::Plane {
        point: [3.0, 4.0, 10.0],
        normal: [0.0, 0.0, 1.0],
    };
    for (shift, wanted) in [
        ([2.0, 3.0, 10.0], 100.0),
        ([15.0, 3.0, 10.0], 50.0),
        ([15.0, -4.0, 10.0], 30.0),
        // An edge only, a corner only, beside, above, within.
        ([20.0, 3.0, 10.0], 0.0),
        ([20.0, 20.0, 10.0], 0.0),
        ([30.0, 0.0, 10.0], 0.0),
        ([2.0, 3.0, 10.001], 0.0),
        ([2.0, 3.0, 9.999], 0.0),
        // Materials on the same side.
        ([2.0, 3.0, 5.0], 0.0),
    ] {
        let [x, y, z] = shift;
        near(
            area(&base, &top, &Placement::translation(x, y, z), &place),
            wanted,
            1e-9,
        );
    }
}

#[test]
fn a_hole_in_the_seat_counts_out() {
    // The floor of a counterbore (radius 5.5 around a hole of 3.3) and a head of 5.
    let plate = cuboid([-20.0, -20.0, 0.0], [40.0, 40.0, 20.0])
        .cut(&cylinder([0.0, 0.0, 0.0], 3.3, 20.0))
        .cut(&cylinder([0.0, 0.0, 13.0], 5.5, 7.0));
    let head = cylinder([0.0; 3], 5.0, 6.0);
    let place = Where::Plane {
        point: [0.0, 0.0, 13.0],
        normal: [0.0, 0.0, 1.0],
    };
    let at = |z| Placement::translation(0.0, 0.0, z);
    near(
        area(&plate, &head, &at(13.0), &place),
        PI * (25.0 - 3.3 * 3.3),
        1e-7,
    );
    near(area(&plate, &head, &at(20.0), &place), 0.0, 1e-9);
}

#[test]
fn a_shaft_fills_its_bore() {
    let block = cuboid([-20.0, -20.0, 0.0], [40.0, 40.0, 20.0]).cut(&cylinder([0.0; 3], 8.0, 20.0));
    let place = Where::Axis {
        point: [0.0, 0.0, -100.0],
        direction: [0.0, 0.0, 1.0],
    };
    let shaft = |radius| cylinder([0.0; 3], radius, 50.0);
    let turned = Placement::rotation_z(33.0);
    let at = |z| Placement::translation(0.0, 0.0, z) * turned;
    // Through, half in, only the mouths touch, apart, too thin, too thick.
    near(
        area(&block, &shaft(8.0), &at(-10.0), &place),
        2.0 * PI * 8.0 * 20.0,
        1e-7,
    );
    near(
        area(&block, &shaft(8.0), &at(12.0), &place),
        2.0 * PI * 8.0 * 8.0,
        1e-7,
    );
    near(area(&block, &shaft(8.0), &at(20.0), &place), 0.0, 1e-9);
    near(area(&block, &shaft(8.0), &at(90.0), &place), 0.0, 1e-9);
    near(area(&block, &shaft(7.99), &at(-10.0), &place), 0.0, 1e-9);
    near(area(&block, &shaft(8.01), &at(-10.0), &place), 0.0, 1e-9);
    // Beside its bore.
    let off = Placement::translation(0.01, 0.0, -10.0);
    near(area(&block, &shaft(8.0), &off, &place), 0.0, 1e-9);
}
