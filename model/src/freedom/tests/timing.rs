//! How long the analysis takes (`cargo test --release -p assemcad-model timings -- --ignored --nocapture`).

use std::time::Instant;

use super::large::{blocks, flange, ring};
use super::{Maker, TURN, X, Z};

/// Bodies in a row, each joined to the next at these heights.
fn chain(n: usize, heights: &[f64], twists: &[[f64; 6]]) -> Maker {
    let names: Vec<String> = (0..n).map(|i| format!("b{i:04}")).collect();
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    let mut m = Maker::new(&names);
    for i in 1..n {
        for (k, z) in heights.iter().enumerate() {
            let axis = if twists.is_empty() && k > 0 { X } else { Z };
            m = m.free(i - 1, i, [25.0 * i as f64, 0.0, *z], axis, twists);
        }
    }
    m
}

fn timed(what: &str, m: &Maker) {
    let start = Instant::now();
    let f = m.solve();
    let took = start.elapsed();
    let told = f.mobility.map(|_| numbers_of(&f));
    println!("{what}: {told:?}, {} idle, {took:?}", f.idle_spins);
}

fn numbers_of(f: &crate::freedom::Freedom) -> (usize, usize, Option<usize>) {
    let redundant = f.redundant.iter().map(|r| r.count).sum();
    (f.mobility.unwrap(), redundant, f.lasting_mobility)
}

#[test]
#[ignore = "a measurement"]
fn timings() {
    timed("40 bodies, twice rigid", &chain(40, &[0.0, 30.0], &[]));
    timed("40 bodies, twice hinged", &chain(40, &[0.0, 30.0], &[TURN]));
    for n in [20, 50, 100, 250, 1000] {
        timed(&format!("{n} bolts, all rigid"), &flange(n, &[]));
        timed(&format!("{n} bolts, washers turn"), &flange(n, &[TURN]));
        timed(
            &format!("{} bodies in a chain", 4 * n),
            &chain(4 * n, &[0.0], &[TURN]),
        );
        timed(&format!("{} bodies in a ring", n), &ring(n));
        timed(&format!("{} blocks", n / 4), &blocks(n / 4));
    }
}
