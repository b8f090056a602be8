//! What must not matter.

use proptest::prelude::*;

use super::linkages::four_bar;
use super::{Maker, TURN, X, Y, Z, placement_of};
use crate::frame::Placement;
use crate::freedom::{Freedom, Hold, System, analyse};
use crate::mates::Twist;

/// Mechanisms of all kinds.
pub(super) fn samples() -> Vec<System> {
    let gears = Maker::new(&["h", "s", "c", "p"])
        .turn(0, 1, [0.0; 3], Z)
        .turn(0, 2, [0.0; 3], Z)
        .turn(2, 3, [18.0, 0.0, 0.0], Z)
        .mesh(1, 3, [0.0; 3], [18.0, 0.0, 0.0], -1.25)
        .mesh(0, 3, [0.0; 3], [18.0, 0.0, 0.0], 3.25);
    let sarrus = Maker::new(&["g", "a1", "a2", "b1", "b2", "top"])
        .turn(0, 1, [50.0, 0.0, 0.0], Y)
        .turn(1, 2, [80.0, 0.0, 20.0], Y)
        .turn(2, 5, [50.0, 0.0, 40.0], Y)
        .turn(0, 3, [0.0, 50.0, 0.0], X)
        .turn(3, 4, [0.0, 80.0, 20.0], X)
        .turn(4, 5, [0.0, 50.0, 40.0], X);
    let screw = Maker::new(&["g", "s", "n", "loose"])
        .turn(0, 1, [0.0; 3], Z)
        .free(1, 2, [0.0, 0.0, 40.0], Z, &[[0.0, 0.0, 1.0, 0.0, 0.0, 0.8]])
        .slide(0, 2, [30.0, 0.0, 40.0], Z)
        .free(
            0,
            1,
            [0.0, 0.0, 70.0],
            Z,
            &[TURN, [0.0, 0.0, 0.0, 0.0, 0.0, 1.0]],
        )
        .round(1, [0.0; 3], Z);
    let flat = four_bar([[0.0, 0.0], [30.0, 0.0], [130.0, 0.0], [100.0, 0.0]]);
    let bar = four_bar([[0.0, 0.0], [10.0, 20.0], [70.0, 45.0], [60.0, 0.0]]);
    vec![gears.0, sarrus.0, screw.0, flat.0, bar.0]
}

type Summary = (
    Option<usize>,
    usize,
    Option<usize>,
    usize,
    Vec<(usize, Vec<String>, Vec<String>)>,
);

fn summary(f: &Freedom) -> Summary {
    let redundant = f
        .redundant
        .iter()
        .map(|r| (r.count, r.mates.clone(), r.dispensable.clone()));
    (
        f.mobility,
        f.idle_spins,
        f.lasting_mobility,
        f.motions.len(),
        redundant.collect(),
    )
}

fn moved(system: &System, by: &Placement, scale: f64) -> System {
    let mut out = system.clone();
    let place = |p: [f64; 3]| by.point(p.map(|c| c * scale));
    for b in &mut out.bodies {
        b.at = place(b.at);
        if let Some(axis) = &mut b.spin {
            axis.point = place(axis.point);
            axis.direction = by.direction(axis.direction);
        }
    }
    for l in &mut out.links {
        let mut rows = crate::frame::Rows::from(l.frame);
        for row in &mut rows.0 {
            row[3] *= scale;
        }
        l.frame = *by * Placement::from(rows);
        match &mut l.hold {
            Hold::Free(twists) => {
                for Twist(t) in twists {
                    t[3..].iter_mut().for_each(|v| *v *= scale);
                }
            }
            Hold::Gears { incoming_axis, .. } => *incoming_axis = place(*incoming_axis),
        }
    }
    out
}

/// Base and incoming of a link exchanged: what one body does against the other, it does the other way.
fn swapped(system: &System, which: usize) -> System {
    let mut out = system.clone();
    let l = &mut out.links[which];
    core::mem::swap(&mut l.base, &mut l.incoming);
    match &mut l.hold {
        Hold::Free(twists) => twists
            .iter_mut()
            .for_each(|t| t.0.iter_mut().for_each(|v| *v = -*v)),
        Hold::Gears {
            incoming_axis,
            ratio,
            ..
        } => {
            let from: [f64; 3] = l.frame.origin().into();
            let z = l.frame.axes()[2];
            let to = nalgebra::Vector3::from(*incoming_axis);
            let x = (nalgebra::Vector3::from(from) - to).normalize();
            let frame = crate::frame::Frame::new(*incoming_axis, z.into(), x.into()).unwrap();
            l.frame = frame.placement().unwrap();
            (*incoming_axis, *ratio) = (from, 1.0 / *ratio);
        }
    }
    out
}

/// Bodies and links in another order; the names stay.
fn reordered(system: &System, turn: usize) -> System {
    let (n, mut out) = (system.bodies.len(), system.clone());
    let to = |i: usize| (i + turn) % n;
    for (i, b) in system.bodies.iter().enumerate() {
        out.bodies[to(i)] = b.clone();
    }
    for l in &mut out.links {
        (l.base, l.incoming) = (to(l.base), to(l.incoming));
    }
    out.links.reverse();
    out.root = system.root.map(to);
    out
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 12, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn neither_place_nor_size_nor_order_nor_side_matters(
        p in prop::array::uniform3(-500.0..500.0f64),
        axis in prop::array::uniform3(0.1..1.0f64),
        deg in -180.0..180.0f64,
        log_scale in -2.0..2.0f64,
        turn in 0..6usize,
    ) {
        for system in samples() {
            let wanted = summary(&analyse(&system));
            let scale = libm::pow(10.0, log_scale);
            let by = placement_of(p.map(|c| c * scale), axis, deg);
            prop_assert_eq!(&summary(&analyse(&moved(&system, &by, scale))), &wanted);
            let other = analyse(&reordered(&system, turn));
            // Not only the numbers: the very same answer.
            prop_assert_eq!(&other, &analyse(&system));
            let which = turn % system.links.len();
            prop_assert_eq!(&summary(&analyse(&swapped(&system, which))), &wanted);
        }
    }
}
