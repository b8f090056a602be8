//! Rigidly joined bodies taken as one, against the same taken one by one.

use super::invariance::samples;
use super::{Maker, TURN, X, Y, Z, numbers};
use crate::freedom::{Body, Freedom, Hold, Link, System, analyse, analyse_as};

/// Every body in three pieces in a row, and every second link on the last of them; the first pieces of the second
/// body are held together twice.
fn in_pieces(system: &System) -> System {
    let mut out = system.clone();
    let n = system.bodies.len();
    for (i, body) in system.bodies.iter().enumerate() {
        for (k, on) in [i, n + 2 * i].into_iter().enumerate() {
            out.bodies.push(Body {
                name: format!("{}_{k}", body.name),
                at: [10.0 * i as f64, 5.0, 7.0 * k as f64],
                spin: body.spin,
            });
            let times = if i == 1 && k == 0 { 2 } else { 1 };
            for time in 0..times {
                out.links.push(Link {
                    name: format!("glue_{i}_{k}_{time}"),
                    base: on,
                    incoming: n + 2 * i + k,
                    frame: system.links[0].frame,
                    hold: Hold::Free(Vec::new()),
                });
            }
        }
    }
    for l in out.links.iter_mut().take(system.links.len()).step_by(2) {
        (l.base, l.incoming) = (n + 2 * l.base + 1, n + 2 * l.incoming + 1);
    }
    out
}

fn agree(system: &System) -> Freedom {
    let (one, other) = (analyse_as(system, true), analyse_as(system, false));
    assert_eq!(numbers(&one), numbers(&other));
    assert_eq!(one.idle_spins, other.idle_spins);
    let names = |f: &Freedom| -> Vec<_> {
        f.motions
            .iter()
            .map(|m| (m.name.clone(), m.idle, m.lasting))
            .collect()
    };
    assert_eq!(names(&one), names(&other));
    assert_eq!(one.redundant, other.redundant);
    assert_eq!(one.joints, other.joints);
    let counted = |f: &Freedom| -> Vec<_> {
        let ranks = |i: &crate::freedom::IslandFacts| (i.constraints, i.rank.unwrap().rank);
        f.islands.iter().map(ranks).collect()
    };
    assert_eq!(counted(&one), counted(&other));
    one
}

#[test]
fn bodies_in_pieces_move_as_the_whole_ones() {
    for system in samples() {
        agree(&system);
        let (whole, pieces) = (analyse(&system), agree(&in_pieces(&system)));
        assert_eq!(pieces.mobility, whole.mobility);
        assert_eq!(pieces.lasting_mobility, whole.lasting_mobility);
        assert_eq!(pieces.idle_spins, whole.idle_spins);
        // What holds a piece twice is found beside what was redundant before.
        let count = |f: &Freedom| f.redundant.iter().map(|r| r.count).sum::<usize>();
        assert_eq!(count(&pieces), count(&whole) + 6);
    }
}

/// A frame of four rigid corners: six constraints too many, and each corner could be left out. A hinge between two
/// of its bodies holds nothing that is not held, and repeats its five.
#[test]
fn what_is_redundant_in_a_rigid_group_is_found() {
    let frame = |hinged: bool| {
        let m = Maker::new(&["a", "b", "c", "d"])
            .free(0, 1, [0.0; 3], Z, &[])
            .free(1, 2, [90.0, 0.0, 0.0], X, &[])
            .free(2, 3, [90.0, 60.0, 0.0], Y, &[])
            .free(3, 0, [0.0, 60.0, 0.0], Z, &[]);
        let m = if hinged {
            m.turn(1, 3, [40.0, 40.0, 0.0], Z)
        } else {
            m
        };
        agree(&m.0)
    };
    let f = frame(false);
    assert_eq!(numbers(&f), (0, 6, 0));
    assert_eq!(f.redundant[0].dispensable, ["j0", "j1", "j2", "j3"]);
    assert_eq!(f.redundant[0].repeated, [6; 4]);
    let f = frame(true);
    assert_eq!(numbers(&f), (0, 11, 0));
    assert_eq!(f.redundant[0].mates, ["j0", "j1", "j2", "j3", "j4"]);
    assert_eq!(f.redundant[0].repeated, [6, 6, 6, 6, 5]);
}

/// Two loops that share nothing but rigid bodies: what is redundant stays apart, unless a rigid link carries the
/// stresses of both.
#[test]
fn loops_share_what_carries_the_stresses_of_both() {
    // A door on two hinges on either end of a bar; the hinges' plates are bodies of their own.
    let doors = |plate: bool| {
        let on = if plate { 3 } else { 0 };
        let m = Maker::new(&["wall", "left", "right", "plate"])
            .free(0, 3, [0.0, 0.0, 5.0], Z, &[])
            .turn(0, 1, [0.0; 3], Z)
            .turn(on, 1, [0.0, 0.0, 800.0], Z)
            .turn(0, 2, [900.0, 0.0, 0.0], Z)
            .turn(on, 2, [900.0, 0.0, 800.0], Z);
        agree(&m.0)
    };
    let groups =
        |f: &Freedom| -> Vec<Vec<String>> { f.redundant.iter().map(|r| r.mates.clone()).collect() };
    let f = doors(false);
    assert_eq!(numbers(&f), (2, 10, 2));
    assert_eq!(groups(&f), [["j1", "j2"], ["j3", "j4"]]);
    let f = doors(true);
    assert_eq!(numbers(&f), (2, 10, 2));
    assert_eq!(groups(&f), [["j0", "j1", "j2", "j3", "j4"]]);
    // The plate's link carries five of each loop, of the six that it can.
    assert_eq!(f.redundant[0].repeated, [6, 5, 5, 5, 5]);
}

/// Two rings on a shaft, pressed onto each other, spin idly as one; a ring about another axis does not.
#[test]
fn rings_on_one_axis_spin_as_one() {
    let rings = |off: f64| {
        let m = Maker::new(&["shaft", "ring", "cap"])
            .turn(0, 1, [0.0; 3], Z)
            .free(1, 2, [0.0, 0.0, 10.0], Z, &[])
            .round(1, [0.0; 3], Z)
            .round(2, [off, 0.0, 10.0], [0.0, 0.0, -1.0]);
        agree(&m.0).idle_spins
    };
    assert_eq!((rings(0.0), rings(3.0)), (1, 0));
}

/// Each body after the first has one hinge's freedom and five constraints too many.
#[test]
fn a_long_chain_of_double_hinges_has_a_motion_for_each() {
    let names: Vec<String> = (0..12).map(|i| format!("b{i:02}")).collect();
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    let mut m = Maker::new(&names);
    for i in 1..names.len() {
        let at = |z: f64| [25.0 * i as f64, 0.0, z];
        m = m
            .free(i - 1, i, at(0.0), Z, &[TURN])
            .free(i - 1, i, at(30.0), Z, &[TURN]);
    }
    let f = agree(&m.0);
    assert_eq!(numbers(&f), (11, 55, 11));
    assert_eq!(f.redundant.len(), 11);
}
