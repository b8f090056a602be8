//! Machines of many parts: solved by elimination, and told as small ones are.

use nalgebra::DMatrix;
use proptest::prelude::*;

use super::{Maker, TURN, Z, lasting, numbers};
use crate::freedom::Lasting;
use crate::freedom::eliminate::eliminate;
use crate::freedom::linear::rank;
use crate::freedom::sparse::Sparse;

const FLAT: [[f64; 6]; 3] = [
    TURN,
    [0.0, 0.0, 0.0, 1.0, 0.0, 0.0],
    [0.0, 0.0, 0.0, 0.0, 1.0, 0.0],
];

/// Two flanges and bolts through both, each with a washer under its head and one under its nut. A washer lies on
/// its flange by `on`; heads and nuts sit fast on their washers, and the thread closes the loop.
pub(super) fn flange(bolts: usize, on: &[[f64; 6]]) -> Maker {
    let mut names = vec!["lower".to_owned(), "upper".to_owned()];
    for i in 0..bolts {
        names.extend(["bolt", "nut", "washer", "under"].map(|n| format!("{n}_{i:04}")));
    }
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    let flat = [
        TURN,
        [0.0, 0.0, 0.0, 1.0, 0.0, 0.0],
        [0.0, 0.0, 0.0, 0.0, 1.0, 0.0],
    ];
    let mut m = Maker::new(&names).free(0, 1, [0.0, 0.0, 20.0], Z, &flat);
    for i in 0..bolts {
        let (sin, cos) = crate::angle::sin_cos_deg(360.0 * i as f64 / bolts as f64);
        let r = 10.0 * bolts as f64;
        let at = |z: f64| [r * cos, r * sin, z];
        let [bolt, nut, washer, under] = [0, 1, 2, 3].map(|k| 2 + 4 * i + k);
        m = m
            .free(1, washer, at(40.0), Z, on)
            .free(washer, bolt, at(42.0), Z, &[])
            .free(0, under, at(0.0), Z, on)
            .free(under, nut, at(-2.0), Z, &[])
            .free(bolt, nut, at(-6.0), Z, &[]);
        for part in [washer, under, bolt, nut] {
            m = m.round(part, at(0.0), Z);
        }
    }
    m
}

/// Blocks on a base, each bolted to it four times with washers that can turn, and a shaft in the bores of all.
pub(super) fn blocks(n: usize) -> Maker {
    let mut names = vec!["base".to_owned(), "shaft".to_owned()];
    for i in 0..n {
        names.push(format!("block_{i:03}"));
        for k in 0..4 {
            names.extend(["bolt", "washer"].map(|n| format!("{n}_{i:03}_{k}")));
        }
    }
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    let mut m = Maker::new(&names);
    for i in 0..n {
        let (block, y) = (2 + 9 * i, 100.0 * i as f64);
        let flat = [
            TURN,
            [0.0, 0.0, 0.0, 1.0, 0.0, 0.0],
            [0.0, 0.0, 0.0, 0.0, 1.0, 0.0],
        ];
        m = m.free(0, block, [0.0, y, 0.0], Z, &flat);
        m = m.free(
            block,
            1,
            [0.0, y, 50.0],
            [0.0, 1.0, 0.0],
            &[TURN, [0.0, 0.0, 0.0, 0.0, 0.0, 1.0]],
        );
        for k in 0..4 {
            let at = |z: f64| {
                [
                    if k % 2 == 0 { 30.0 } else { -30.0 },
                    y + if k < 2 { 20.0 } else { -20.0 },
                    z,
                ]
            };
            let (bolt, washer) = (block + 1 + 2 * k, block + 2 + 2 * k);
            m = m
                .turn(block, washer, at(20.0), Z)
                .turn(washer, bolt, at(22.0), Z)
                .free(0, bolt, at(0.0), Z, &[]);
            m = m.round(washer, at(0.0), Z);
        }
    }
    m
}

/// A closed loop of hinges about one direction.
pub(super) fn ring(n: usize) -> Maker {
    let names: Vec<String> = (0..n).map(|i| format!("b{i:04}")).collect();
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    let mut m = Maker::new(&names);
    for i in 0..n {
        let (sin, cos) = crate::angle::sin_cos_deg(360.0 * i as f64 / n as f64 + 0.3);
        m = m.turn(i, (i + 1) % n, [100.0 * cos, 70.0 * sin, 0.0], Z);
    }
    m
}

/// Each bolt holds six of which the loop needs none, a washer's turn twice; the first loop holds the upper flange,
/// which the faces hold too in three.
#[test]
fn bolts_by_the_dozen_are_told_as_one() {
    for bolts in [4, 60] {
        let f = flange(bolts, &[TURN]).solve();
        assert_eq!(numbers(&f), (bolts, 5 * bolts - 3, bolts));
        assert_eq!(f.idle_spins, bolts);
        let f = flange(bolts, &[]).solve();
        assert_eq!(numbers(&f), (0, 6 * bolts - 3, 0));
        // The upper flange is where all loops meet.
        assert_eq!(f.redundant.len(), 1);
        assert_eq!(f.redundant[0].mates.len(), 5 * bolts + 1);
    }
}

/// A shaft turns and slides in the bores of blocks that bolts hold: a motion of a large block with redundant rows.
#[test]
fn a_shaft_in_many_blocks_turns() {
    for n in [2, 6] {
        let f = blocks(n).solve();
        assert_eq!(f.idle_spins, 4 * n);
        assert_eq!(f.mobility, Some(4 * n + 2));
        assert_eq!(f.lasting_mobility, f.mobility);
        assert_eq!(f.motions.last().unwrap().name, "'shaft' slides along y");
    }
}

/// A closed chain of n hinges about one direction has n - 3 motions and holds three freedoms twice.
#[test]
fn a_long_closed_chain_moves() {
    for n in [5, 40] {
        let f = ring(n).solve();
        assert_eq!(numbers(&f), (n - 3, 3, n - 3));
    }
}

/// A stretched dyad whose second bar is two plates that bolts hold together: it gives way for an instant only, which
/// elimination alone does not tell.
#[test]
fn what_gives_way_for_an_instant_is_told_in_a_large_block_too() {
    let bolts = 20;
    let mut names = vec![
        "ground".to_owned(),
        "a".to_owned(),
        "low".to_owned(),
        "high".to_owned(),
    ];
    names.extend((0..bolts).map(|i| format!("ring_{i:02}")));
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    let mut m = Maker::new(&names)
        .turn(0, 1, [0.0; 3], Z)
        .turn(1, 2, [50.0, 0.0, 0.0], Z)
        .free(2, 3, [80.0, 0.0, 5.0], Z, &FLAT)
        .turn(3, 0, [120.0, 0.0, 0.0], Z);
    for i in 0..bolts {
        let at = [
            60.0 + 2.0 * i as f64,
            if i % 2 == 0 { 5.0 } else { -5.0 },
            5.0,
        ];
        m = m
            .turn(2, 4 + i, at, Z)
            .turn(4 + i, 3, at, Z)
            .round(4 + i, at, Z);
    }
    let f = m.solve();
    assert_eq!((f.mobility, f.idle_spins), (Some(bolts + 1), bolts));
    assert_eq!(f.lasting_mobility, Some(bolts));
    assert_eq!(lasting(&f)[bolts..], [Lasting::Instantaneous]);
}

fn entries() -> impl Strategy<Value = Vec<(usize, usize, f64)>> {
    prop::collection::vec((0..20usize, 0..24usize, -1.0..1.0f64), 0..120)
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    /// Rank and null spaces by elimination are those by singular values; every third row is the sum of two others.
    #[test]
    fn elimination_agrees_with_singular_values(entries in entries(), width in 1..7usize) {
        let mut dense = DMatrix::zeros(30, 24);
        for (i, j, x) in entries {
            dense[(i, j)] = x;
        }
        for i in 0..10 {
            let sum = dense.row(2 * i) + dense.row(2 * i + 1);
            dense.set_row(20 + i, &sum);
        }
        let rows: Vec<Sparse> = dense.row_iter().map(|r| Sparse::of(r.iter().copied())).collect();
        let (found, known) = (eliminate(&rows, 24, width, true).unwrap(), rank(&dense).unwrap());
        prop_assume!(known.is_clear() && found.rank.is_clear());
        prop_assert_eq!(found.rank.rank, known.rank);
        let free = found.null_space(&rows).unwrap();
        prop_assert_eq!(free.len(), 24 - known.rank);
        for (v, unknown) in free.iter().zip(&found.free) {
            prop_assert_eq!(v.get(*unknown), 1.0);
            prop_assert!((&dense * v.dense(24)).amax() < 1e-9 * v.amax());
        }
        let stresses = found.stresses(&rows).unwrap();
        prop_assert_eq!(stresses.len(), 30 - known.rank);
        for s in &stresses {
            prop_assert!((dense.transpose() * s.dense(30)).amax() < 1e-9 * s.amax());
        }
        let all = DMatrix::from_columns(&stresses.iter().map(|s| s.dense(30)).collect::<Vec<_>>());
        prop_assert_eq!(rank(&all).unwrap().rank, stresses.len());
    }

    /// What is solved for is met, where the right side is one that can be.
    #[test]
    fn a_solution_meets_the_right_side(entries in entries(), x in prop::array::uniform24(-1.0..1.0f64)) {
        let mut dense = DMatrix::zeros(20, 24);
        for (i, j, a) in entries {
            dense[(i, j)] = a;
        }
        let right = &dense * nalgebra::DVector::from_row_slice(&x);
        let mut rows: Vec<Sparse> = dense.row_iter().map(|r| Sparse::of(r.iter().copied())).collect();
        for (row, b) in rows.iter_mut().zip(right.iter()) {
            row.push(24, *b);
        }
        let found = eliminate(&rows, 24, 6, false).unwrap();
        prop_assume!(found.rank.smallest_counted > 1e-4);
        let solved = nalgebra::DVector::from_vec(found.solution());
        prop_assert!((dense * solved - right).amax() < 1e-8);
    }
}
