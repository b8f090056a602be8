//! How long the analysis takes (`cargo test -p assemcad-model timing -- --ignored --nocapture`).

use std::time::Instant;

use super::{Maker, X, Z};

/// Forty bodies in a row, each joined to the next twice.
fn chain(twists: &[[f64; 6]]) -> Maker {
    let names: Vec<String> = (0..40).map(|i| format!("b{i:02}")).collect();
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    let mut m = Maker::new(&names);
    for i in 1..40 {
        let at = |z: f64| [f64::from(i) * 25.0, 0.0, z];
        let to = usize::try_from(i).unwrap();
        m = m.free(to - 1, to, at(0.0), Z, twists);
        m = m.free(
            to - 1,
            to,
            at(30.0),
            if twists.is_empty() { X } else { Z },
            twists,
        );
    }
    m
}

#[test]
#[ignore = "a measurement"]
fn timings() {
    for (what, m) in [("rigid", chain(&[])), ("hinged", chain(&[super::TURN]))] {
        let start = Instant::now();
        let f = m.solve();
        println!("{what}: mobility {:?}, {:?}", f.mobility, start.elapsed());
    }
}
