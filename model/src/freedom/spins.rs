//! Idle spins: bodies that turn about axes of their own, about which they look the same.

use std::collections::BTreeMap;

use nalgebra::DMatrix;

use super::eliminate::eliminate;
use super::linear::{null_space_by, rank_above, set};
use super::model::Model;
use super::rigid::Rigid;
use super::sparse::Sparse;

/// Beyond so many spins that act on each other they are eliminated one by one.
const MOST_SPINS: usize = 60;

/// Motions in which bodies turn about axes of their own and nothing else moves.
pub(super) fn idle(model: &Model) -> Vec<Sparse> {
    let found = model.spins.iter().enumerate();
    let spins: Vec<(usize, Sparse)> = found
        .filter_map(|(u, spin)| {
            let mut v = Sparse::default();
            v.push_twist(u, spin.as_ref()?);
            Some((u, v))
        })
        .collect();
    if spins.is_empty() {
        return Vec::new();
    }
    let mut column: Vec<Option<usize>> = vec![None; model.units];
    for (k, (u, _)) in spins.iter().enumerate() {
        if let Some(slot) = column.get_mut(*u) {
            *slot = Some(k);
        }
    }
    // The rows' work in each spin.
    let still = Rigid::IDENTITY;
    let mut work: Vec<Sparse> = Vec::new();
    for tie in model.ties.iter().filter(|t| t.base != t.incoming) {
        let of = |unit: Option<usize>, sign: f64| {
            let k = column.get(unit?).copied().flatten()?;
            Some((k, spins.get(k)?.1.twist(unit) * sign))
        };
        let mut ends: Vec<_> = [of(tie.base, -1.0), of(tie.incoming, 1.0)]
            .into_iter()
            .flatten()
            .collect();
        ends.sort_by_key(|(k, _)| *k);
        if !ends.is_empty() {
            let rows = tie.scaled.jacobian(&still, &still);
            work.extend(
                rows.iter()
                    .map(|w| Sparse::new(ends.iter().map(|(k, s)| (*k, w.dot(s))))),
            );
        }
    }
    let mut out: Vec<(usize, Sparse)> = Vec::new();
    for (columns, rows) in together(spins.len(), &work) {
        for (unknown, weights) in free_spins(&columns, &rows) {
            let of = |(k, by): &(usize, f64)| spins.get(*k).map(|(_, v)| (v, *by));
            let parts = weights.entries().iter().filter_map(of);
            let all = parts.flat_map(|(v, by)| v.entries().iter().map(move |(i, x)| (*i, x * by)));
            out.push((unknown, Sparse::new(all)));
        }
    }
    out.sort_by_key(|(unknown, _)| *unknown);
    out.into_iter().map(|(_, v)| v).collect()
}

/// The columns in sets that no row joins, each with its rows.
fn together(columns: usize, rows: &[Sparse]) -> Vec<(Vec<usize>, Vec<&Sparse>)> {
    let mut set: Vec<usize> = (0..columns).collect();
    let first = |set: &[usize], of: usize| {
        let mut at = of;
        while let Some(up) = set.get(at).filter(|up| **up != at) {
            at = *up;
        }
        at
    };
    let entry = |row: &Sparse| row.entries().first().map(|(c, _)| *c);
    for row in rows {
        for (c, _) in row.entries() {
            let (a, b) = (first(&set, entry(row).unwrap_or(*c)), first(&set, *c));
            for of in [a.max(b), *c] {
                if let Some(slot) = set.get_mut(of) {
                    *slot = a.min(b);
                }
            }
        }
    }
    let mut out: BTreeMap<usize, (Vec<usize>, Vec<&Sparse>)> = BTreeMap::new();
    for c in 0..columns {
        out.entry(first(&set, c)).or_default().0.push(c);
    }
    for row in rows {
        if let Some((_, list)) = entry(row).and_then(|c| out.get_mut(&first(&set, c))) {
            list.push(row);
        }
    }
    out.into_values().collect()
}

/// Which combinations of spins the rows let go, each by the unknown that is 1 in it alone.
fn free_spins(columns: &[usize], rows: &[&Sparse]) -> Vec<(usize, Sparse)> {
    let own = |row: &&Sparse| {
        let place = |(c, x): &(usize, f64)| Some((columns.binary_search(c).ok()?, *x));
        Sparse::new(row.entries().iter().filter_map(place))
    };
    let rows: Vec<Sparse> = rows.iter().map(own).collect();
    let found: Vec<(usize, Sparse)> = if columns.len() > MOST_SPINS {
        // What cannot be told spins no machine part idly.
        let done = eliminate(&rows, columns.len(), 1, false);
        let free = done.and_then(|e| Some((e.null_space(&rows)?, e.free)));
        free.map_or_else(Vec::new, |(all, by)| by.into_iter().zip(all).collect())
    } else {
        let mut work = DMatrix::zeros(rows.len(), columns.len());
        for (i, row) in rows.iter().enumerate() {
            for (c, x) in row.entries() {
                set(&mut work, i, *c, *x);
            }
        }
        let (by, free) = null_space_by(&work, rank_above(&work));
        let each = free.column_iter().map(|c| Sparse::of(c.iter().copied()));
        by.into_iter().zip(each).collect()
    };
    let there = |c: usize| columns.get(c).copied().unwrap_or(usize::MAX);
    let moved = |v: Sparse| Sparse::new(v.entries().iter().map(|(c, x)| (there(*c), *x)));
    found
        .into_iter()
        .map(|(c, v)| (there(c), moved(v)))
        .collect()
}
