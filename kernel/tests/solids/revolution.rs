//! Solids of revolution, and what only looks like one.

use assemcad_kernel::Shape;
use assemcad_kernel::revolution::is_about;

use super::common::{Two, cuboid, cylinder};

const Z: [f64; 3] = [0.0, 0.0, 1.0];

fn about(shape: &Shape, point: [f64; 3], direction: [f64; 3]) -> bool {
    is_about(&shape.faces().unwrap(), point, direction)
}

#[test]
fn a_stepped_shaft_is_one_about_its_own_axis_only() {
    let shaft = cylinder([4.0, 5.0, 0.0], 6.0, 20.0).fuse(&cylinder([4.0, 5.0, 20.0], 3.0, 9.0));
    let bored = shaft.cut(&cylinder([4.0, 5.0, -1.0], 1.0, 40.0));
    for shape in [&shaft, &bored] {
        assert!(about(shape, [4.0, 5.0, 99.0], Z));
        assert!(about(shape, [4.0, 5.0, 0.0], [0.0, 0.0, -1.0]));
        assert!(!about(shape, [4.0, 5.001, 0.0], Z));
        assert!(!about(shape, [4.0, 5.0, 0.0], [0.0, 1e-3, 1.0]));
        assert!(!about(shape, [4.0, 5.0, 0.0], [1.0, 0.0, 0.0]));
    }
}

#[test]
fn what_only_looks_round_is_none() {
    let disc = || cylinder([0.0; 3], 10.0, 5.0);
    // A key's slot, an eccentric bore, half of it, and a block: each has a face that a turn moves.
    let keyed = disc().cut(&cuboid([8.0, -1.0, -1.0], [4.0, 2.0, 9.0]));
    let eccentric = disc().cut(&cylinder([3.0, 0.0, -1.0], 1.0, 9.0));
    let half = disc().cut(&cuboid([0.0, -20.0, -1.0], [40.0, 40.0, 9.0]));
    let block = cuboid([-1.0, -1.0, 0.0], [2.0, 2.0, 5.0]);
    for shape in [keyed, eccentric, half, block] {
        assert!(!about(&shape, [0.0; 3], Z));
    }
    assert!(about(&disc(), [0.0; 3], Z));
    assert!(!is_about(&[], [0.0; 3], Z));
}
