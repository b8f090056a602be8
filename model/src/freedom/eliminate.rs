//! Rank, null spaces and solutions of large sparse systems, by elimination unit by unit.
//!
//! Of the units that are left, the one with the fewest rows goes next; within its rows the largest entry is the
//! pivot, again and again (Duff, Erisman and Reid, *Direct Methods for Sparse Matrices*, 1986). Pivots that are
//! small beside the others wait until the end, where the largest of all goes first. A row that comes to nothing is a
//! combination of rows that adds up to nothing. So a machine of many small loops about a few large parts takes
//! about as long as its loops one by one.

use std::collections::{BTreeMap, BTreeSet};

use super::linear::{RANK_TOLERANCE, Rank};
use super::sparse::Sparse;

/// Entries up to this are rounding: rows are of about unit length.
const NOISE: f64 = 1e-13;
/// Columns whose entries are up to this have none that could be a pivot.
const NOTHING: f64 = 1e-11;
/// Pivots below this wait until the end.
const WEAK: f64 = 1e-2;
/// How far a row may be off 0 for what is to be taken to nothing.
const OFF: f64 = 1e-9;
/// How many entries are written before a system counts as too large: some seconds of work.
const MOST_WORK: usize = 400_000_000;

/// What came of an elimination.
#[derive(Debug)]
pub(super) struct Eliminated {
    pub(super) rank: Rank,
    pivots: Vec<Pivot>,
    /// The unknowns that are no pivots, in order.
    pub(super) free: Vec<usize>,
    stresses: Vec<Sparse>,
    columns: usize,
}

#[derive(Debug)]
struct Pivot {
    column: usize,
    value: f64,
    row: Sparse,
}

struct Work {
    rows: Vec<Sparse>,
    /// What each row is of the rows as they were given; none where nobody asks.
    made_of: Option<Vec<Sparse>>,
    live: Vec<bool>,
    width: usize,
    columns: usize,
    /// The rows of each unit, and about how many there are.
    of: Vec<Vec<usize>>,
    count: Vec<usize>,
    queue: BTreeSet<(usize, usize)>,
    /// Columns that wait until the end.
    late: Vec<usize>,
    pivots: Vec<Pivot>,
    largest_zero: f64,
    work: usize,
}

/// Eliminates rows in units of so many unknowns. An entry beyond the unknowns is a right side. None where a number is
/// not finite, or the system is too large.
pub(super) fn eliminate(
    rows: &[Sparse],
    columns: usize,
    width: usize,
    combinations: bool,
) -> Option<Eliminated> {
    let all = || rows.iter().flat_map(Sparse::entries);
    if all().any(|(_, x)| !x.is_finite()) {
        return None;
    }
    let units = columns.div_ceil(width.max(1));
    let mut work = Work {
        rows: rows.to_vec(),
        made_of: combinations.then(|| (0..rows.len()).map(|i| Sparse::new([(i, 1.0)])).collect()),
        live: vec![true; rows.len()],
        width: width.max(1),
        columns,
        of: vec![Vec::new(); units],
        count: vec![0; units],
        queue: BTreeSet::new(),
        late: Vec::new(),
        pivots: Vec::new(),
        largest_zero: 0.0,
        work: 0,
    };
    for (k, row) in rows.iter().enumerate() {
        for unit in work.units_of(row) {
            work.touch(unit, k);
        }
    }
    work.queue = work.count.iter().copied().zip(0..).collect();
    while let Some((_, unit)) = work.queue.pop_first() {
        work.unit(unit);
        if work.work > MOST_WORK {
            return None;
        }
    }
    work.rest()?;
    Some(work.done())
}

impl Work {
    fn units_of(&self, row: &Sparse) -> Vec<usize> {
        let mut out = row.groups(self.width);
        out.retain(|u| *u < self.of.len());
        out
    }

    fn touch(&mut self, unit: usize, row: usize) {
        if let Some(list) = self.of.get_mut(unit) {
            list.push(row);
        }
        self.counted(unit, |n| n + 1);
    }

    fn counted(&mut self, unit: usize, by: impl Fn(usize) -> usize) {
        let Some(count) = self.count.get_mut(unit) else {
            return;
        };
        let was = *count;
        *count = by(was);
        if self.queue.remove(&(was, unit)) {
            self.queue.insert((*count, unit));
        }
    }

    fn row(&self, k: usize) -> Option<&Sparse> {
        self.rows.get(k)
    }

    /// Takes a unit out of all rows.
    fn unit(&mut self, unit: usize) {
        let mut ids = self
            .of
            .get_mut(unit)
            .map(core::mem::take)
            .unwrap_or_default();
        ids.sort_unstable();
        ids.dedup();
        ids.retain(|k| self.live.get(*k).copied().unwrap_or_default());
        let first = unit * self.width;
        let mut open: Vec<usize> = (first..(first + self.width).min(self.columns)).collect();
        loop {
            let mut best: Option<(usize, usize, f64)> = None;
            for k in &ids {
                let Some(row) = self.row(*k) else { continue };
                for column in &open {
                    let x = row.get(*column);
                    let most = best.map_or(0.0, |(_, _, b)| b.abs());
                    // The margin keeps rounding from choosing between equals.
                    if x.abs() > most * (1.0 + 1e-9) {
                        best = Some((*k, *column, x));
                    }
                }
            }
            let Some((k, column, value)) = best.filter(|(_, _, x)| x.abs() >= WEAK) else {
                break;
            };
            open.retain(|c| *c != column);
            ids.retain(|i| *i != k);
            self.pivot(k, column, value, &ids);
        }
        for column in open {
            let each = ids.iter().filter_map(|k| self.row(*k));
            let most = each.fold(0.0, |most: f64, r| most.max(r.get(column).abs()));
            if most > NOTHING {
                self.late.push(column);
                continue;
            }
            self.largest_zero = self.largest_zero.max(most);
            for k in &ids {
                if let Some(row) = self.rows.get_mut(*k) {
                    row.retain(|c, _| c != column);
                }
            }
        }
    }

    /// Makes a row the pivot of a column and takes the column out of others.
    fn pivot(&mut self, k: usize, column: usize, value: f64, others: &[usize]) {
        let Some(row) = self.rows.get_mut(k).map(core::mem::take) else {
            return;
        };
        let made_of = self.made_of.as_ref().and_then(|m| m.get(k)).cloned();
        if let Some(live) = self.live.get_mut(k) {
            *live = false;
        }
        let units = self.units_of(&row);
        for unit in &units {
            self.counted(*unit, |n| n.saturating_sub(1));
        }
        for other in others {
            let Some(old) = self.rows.get(*other) else {
                continue;
            };
            let by = old.get(column) / value;
            if by == 0.0 {
                continue;
            }
            let had = self.units_of(old);
            let mut new = old.less(&row, by, NOISE);
            new.retain(|c, _| c != column);
            self.work += new.entries().len() + 1;
            if let Some(slot) = self.rows.get_mut(*other) {
                *slot = new;
            }
            if let (Some(own), Some(all)) = (&made_of, &mut self.made_of)
                && let Some(slot) = all.get_mut(*other)
            {
                *slot = slot.less(own, by, NOISE);
                self.work += slot.entries().len();
            }
            for unit in units.iter().filter(|u| had.binary_search(u).is_err()) {
                self.touch(*unit, *other);
            }
        }
        self.pivots.push(Pivot { column, value, row });
    }

    /// The columns that waited: the largest entry of all goes first.
    fn rest(&mut self) -> Option<()> {
        let live = self.live.iter().enumerate().filter(|(_, live)| **live);
        let mut ids: Vec<usize> = live.map(|(k, _)| k).collect();
        ids.retain(|k| {
            let row = self.row(*k);
            row.is_some_and(|r| r.entries().iter().any(|(c, _)| *c < self.columns))
        });
        loop {
            let mut best: Option<(usize, usize, f64)> = None;
            for k in &ids {
                for (column, x) in self.row(*k).map(Sparse::entries).unwrap_or_default() {
                    let most = best.map_or(0.0, |(_, _, b)| b.abs());
                    if *column < self.columns && x.abs() > most * (1.0 + 1e-9) {
                        best = Some((*k, *column, *x));
                    }
                }
                self.work += 1;
            }
            if self.work > MOST_WORK {
                return None;
            }
            let Some((k, column, value)) = best else {
                return Some(());
            };
            if value.abs() <= RANK_TOLERANCE {
                self.largest_zero = self.largest_zero.max(value.abs());
                return Some(());
            }
            ids.retain(|i| *i != k);
            let others = ids.clone();
            self.late.retain(|c| *c != column);
            self.pivot(k, column, value, &others);
        }
    }

    fn done(self) -> Eliminated {
        let mut smallest = 1.0_f64;
        let mut bound = vec![false; self.columns];
        for p in &self.pivots {
            smallest = smallest.min(p.value.abs());
            if let Some(b) = bound.get_mut(p.column) {
                *b = true;
            }
        }
        let unbound = bound.iter().enumerate().filter(|(_, b)| !**b);
        let made_of = self.made_of.unwrap_or_default();
        let left = made_of.into_iter().zip(&self.live);
        Eliminated {
            rank: Rank {
                rank: self.pivots.len(),
                largest_zero: self.largest_zero,
                smallest_counted: smallest,
            },
            free: unbound.map(|(c, _)| c).collect(),
            stresses: left.filter(|(_, live)| **live).map(|(s, _)| s).collect(),
            pivots: self.pivots,
            columns: self.columns,
        }
    }
}

impl Eliminated {
    /// A basis of what the rows take to nothing: for each free unknown the motion in which it is 1 and the other free
    /// unknowns are 0. None where the rows do not take it to nothing.
    pub(super) fn null_space(&self, rows: &[Sparse]) -> Option<Vec<Sparse>> {
        let mut users: Vec<Vec<usize>> = vec![Vec::new(); self.columns];
        for (p, pivot) in self.pivots.iter().enumerate() {
            for (column, _) in pivot.row.entries() {
                if *column != pivot.column
                    && let Some(list) = users.get_mut(*column)
                {
                    list.push(p);
                }
            }
        }
        let of = |column: &usize| users.get(*column).map(Vec::as_slice).unwrap_or_default();
        let mut out = Vec::new();
        for free in &self.free {
            let mut x = BTreeMap::from([(*free, 1.0)]);
            let mut open: BTreeSet<usize> = of(free).iter().copied().collect();
            // Each pivot's row has only columns that were pivots later, or are free.
            while let Some(pivot) = open.pop_last().and_then(|p| self.pivots.get(p)) {
                let known = |(c, a): &(usize, f64)| x.get(c).map(|x| a * x);
                let sum: f64 = pivot.row.entries().iter().filter_map(known).sum();
                if sum.abs() > NOISE {
                    x.insert(pivot.column, -sum / pivot.value);
                    open.extend(of(&pivot.column));
                }
            }
            out.push(Sparse::new(x));
        }
        let mut by_column: Vec<Vec<(usize, f64)>> = vec![Vec::new(); self.columns];
        for (k, row) in rows.iter().enumerate() {
            for (column, a) in row.entries() {
                if let Some(list) = by_column.get_mut(*column) {
                    list.push((k, *a));
                }
            }
        }
        let holds = |x: &Sparse| {
            let of = |c: &usize| by_column.get(*c).map(Vec::as_slice).unwrap_or_default();
            let all = x
                .entries()
                .iter()
                .flat_map(|(c, x)| of(c).iter().map(move |(k, a)| (*k, a * x)));
            all_near_zero(all, x.amax())
        };
        out.iter().all(holds).then_some(out)
    }

    /// The combinations of rows that add up to nothing. None where they do not.
    pub(super) fn stresses(&self, rows: &[Sparse]) -> Option<Vec<Sparse>> {
        let holds = |s: &Sparse| {
            let row = |k: &usize| rows.get(*k).map(Sparse::entries).unwrap_or_default();
            let of = |(k, w): &(usize, f64)| {
                let w = *w;
                row(k).iter().map(move |(c, a)| (*c, a * w))
            };
            all_near_zero(s.entries().iter().flat_map(of), s.amax())
        };
        self.stresses
            .iter()
            .all(holds)
            .then(|| self.stresses.clone())
    }

    /// The unknowns that meet the right sides of the pivots' rows, the free ones being 0.
    pub(super) fn solution(&self) -> Vec<f64> {
        let mut x = vec![0.0; self.columns];
        for pivot in self.pivots.iter().rev() {
            let mut sum = 0.0;
            for (c, a) in pivot.row.entries() {
                if *c == self.columns {
                    sum += a;
                } else if *c != pivot.column {
                    sum -= a * x.get(*c).copied().unwrap_or_default();
                }
            }
            if let Some(slot) = x.get_mut(pivot.column) {
                *slot = sum / pivot.value;
            }
        }
        x
    }
}

/// Whether sums by index are nothing beside a size.
fn all_near_zero(terms: impl Iterator<Item = (usize, f64)>, size: f64) -> bool {
    let mut sums: BTreeMap<usize, f64> = BTreeMap::new();
    for (k, x) in terms {
        *sums.entry(k).or_default() += x;
    }
    sums.values().all(|s| s.abs() <= OFF * size.max(1.0))
}
