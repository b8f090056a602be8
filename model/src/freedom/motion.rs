//! A basis of the free motions in which each has a name.
//!
//! The basis is the null space's reduced echelon form over these coordinates, in this order: the spins of bodies
//! about their own axes; the rates of the links along what they leave free, links nearest to the ground first,
//! then by name; the bodies' twists. Each motion then has one coordinate, its driver, at 1, at which all others
//! stand still: a chain of joints comes out joint by joint, a mechanism as driven by its joint at the ground.

use super::model::{Model, Tie};
use super::rigid::angular;
use super::sparse::{Sparse, Touching};
use super::spins::idle;

/// Free motions as twists of all moving bodies, in the island's units.
pub(super) struct Basis {
    pub(super) motions: Vec<Sparse>,
    /// How many of them, the first ones, are idle spins.
    pub(super) idle: usize,
    /// Of each motion the coordinate that is 1 in it and 0 in all others.
    pub(super) drivers: Vec<Driver>,
}

/// A coordinate that stands for a motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Driver {
    /// The spin of a unit about its own axis.
    Spin(usize),
    /// The rate of a tie, by its index, along one of its free twists.
    Joint(usize, usize),
    /// A component of a unit's twist.
    Entry(usize),
}

impl Driver {
    /// Whether it is a travel.
    pub(super) fn travels(self, model: &Model) -> bool {
        match self {
            Self::Spin(_) => false,
            Self::Joint(tie, k) => {
                let tie = model.ties.get(tie);
                let twist = tie.and_then(|t| t.scaled.free().get(k));
                twist.is_some_and(|t| angular(t).norm() == 0.0)
            }
            Self::Entry(row) => row % 6 >= 3,
        }
    }
}

/// A driver's rate below this share of the fastest coordinate leads to another choice of driver.
const SLOW: f64 = 1e-3;
/// Below this share of the largest component a body stands still.
pub(super) const STILL: f64 = 1e-7;

pub(super) fn basis(model: &Model, free: &[Sparse]) -> Basis {
    let mut all = idle(model);
    let idle = all.len();
    let scaled = |c: &Sparse| c.divided(c.amax().max(f64::MIN_POSITIVE));
    all.extend(free.iter().map(scaled));
    let mut drivers = Vec::new();
    let mut touching = Touching::new(model.units, 6, &all);
    for k in 0..idle {
        let Some(v) = all.get(k) else { break };
        let pivot = v.iamax();
        let v = v.divided(v.get(pivot));
        drivers.push(Driver::Spin(pivot / 6));
        for i in touching.of(pivot / 6).into_iter().filter(|i| *i != k) {
            let Some(other) = all.get_mut(i) else {
                continue;
            };
            let by = other.get(pivot);
            if by != 0.0 {
                *other = other.less(&v, by, 0.0);
                touching.note(i, other);
            }
        }
        if let Some(slot) = all.get_mut(k) {
            *slot = v;
        }
    }
    let left = all.split_off(idle);
    let mut echelon = Echelon::new(model, left);
    for slow in [SLOW, STILL] {
        echelon.pass(slow, free.len().saturating_sub(idle));
    }
    let rows = echelon.order.iter().map(|r| echelon.coordinates.driver(*r));
    drivers.extend(rows);
    all.extend(echelon.motions());
    Basis {
        motions: all,
        idle,
        drivers,
    }
}

/// Motions on their way to the echelon form.
struct Echelon<'a> {
    coordinates: Coordinates<'a>,
    all: Vec<Reduced>,
    /// Which of them have each rate and, once that is asked, each component.
    rates: Touching,
    components: Option<Touching>,
    /// The rows of the drivers, as they were chosen, and the motion of each.
    order: Vec<usize>,
    chosen: Vec<usize>,
}

/// A motion with its rates; its components are the coordinates behind them.
struct Reduced {
    rates: Sparse,
    v: Sparse,
    /// The greatest coordinate and the greatest component.
    most: f64,
    size: f64,
    chosen: bool,
}

impl Reduced {
    fn new(rates: Sparse, v: Sparse, chosen: bool) -> Self {
        let size = v.amax();
        Self {
            most: rates.amax().max(size),
            size,
            rates,
            v,
            chosen,
        }
    }

    /// A coordinate, of so many rates and the components.
    fn coordinate(&self, row: usize, rates: usize) -> f64 {
        match row.checked_sub(rates) {
            Some(component) => self.v.get(component),
            None => self.rates.get(row),
        }
    }

    /// Itself less so much of another one.
    fn less(&self, rates: &Sparse, v: &Sparse, by: f64) -> Self {
        let (rates, v) = (self.rates.less(rates, by, 0.0), self.v.less(v, by, 0.0));
        Self::new(rates, v, self.chosen)
    }
}

impl<'a> Echelon<'a> {
    fn new(model: &'a Model, motions: Vec<Sparse>) -> Self {
        let coordinates = Coordinates::new(model);
        let with_rates = |v: Sparse| Reduced::new(coordinates.of(&v), v, false);
        let all: Vec<Reduced> = motions.into_iter().map(with_rates).collect();
        let mut rates = Touching::new(coordinates.rates, 1, &[]);
        for (i, m) in all.iter().enumerate() {
            rates.note(i, &m.rates);
        }
        Self {
            coordinates,
            all,
            rates,
            components: None,
            order: Vec::new(),
            chosen: Vec::new(),
        }
    }

    /// The motions that have a coordinate, in order.
    fn touching(&mut self, row: usize) -> Vec<usize> {
        let Some(component) = row.checked_sub(self.coordinates.rates) else {
            return self.rates.of(row);
        };
        let all = &self.all;
        let components = self.components.get_or_insert_with(|| {
            let mut out = Touching::new(self.coordinates.count - self.coordinates.rates, 1, &[]);
            for (i, m) in all.iter().enumerate() {
                out.note(i, &m.v);
            }
            out
        });
        components.of(component)
    }

    /// Chooses drivers row by row, among motions that are not slow there.
    fn pass(&mut self, slow: f64, wanted: usize) {
        for row in 0..self.coordinates.count {
            if self.chosen.len() >= wanted {
                break;
            }
            let touching = self.touching(row);
            let mut best: Option<(usize, f64)> = None;
            for i in &touching {
                let Some(m) = self.all.get(*i).filter(|m| !m.chosen) else {
                    continue;
                };
                let rate = m.coordinate(row, self.coordinates.rates).abs();
                let most = best.map_or(0.0, |(_, b)| b);
                if rate > most * (1.0 + 1e-9) && rate > slow * m.most && m.size > STILL {
                    best = Some((*i, rate));
                }
            }
            if let Some((i, _)) = best {
                self.choose(i, row, &touching);
            }
        }
    }

    fn choose(&mut self, i: usize, row: usize, touching: &[usize]) {
        let at = self.coordinates.rates;
        let Some(m) = self.all.get_mut(i) else { return };
        let by = m.coordinate(row, at);
        let (rates, v) = (m.rates.divided(by), m.v.divided(by));
        *m = Reduced::new(rates.clone(), v.clone(), true);
        for k in touching.iter().filter(|k| **k != i) {
            let Some(other) = self.all.get_mut(*k) else {
                continue;
            };
            let by = other.coordinate(row, at);
            if by != 0.0 {
                *other = other.less(&rates, &v, by);
                self.rates.note(*k, &other.rates);
                if let Some(components) = &mut self.components {
                    components.note(*k, &other.v);
                }
            }
        }
        self.order.push(row);
        self.chosen.push(i);
    }

    /// The chosen motions, in their order.
    fn motions(&mut self) -> Vec<Sparse> {
        let chosen = core::mem::take(&mut self.chosen);
        let motion = |i: usize| self.all.get_mut(i).map(|m| core::mem::take(&mut m.v));
        chosen.into_iter().filter_map(motion).collect()
    }
}

/// The coordinates of motions, in the order in which they are chosen as drivers: the rates of the ties, by their
/// farther body as found from the ground, then by name; then the components of the twists.
struct Coordinates<'a> {
    /// The ties with their indices and the coordinate of each one's first rate.
    order: Vec<(usize, &'a Tie, usize)>,
    /// The places in that order of each unit's ties.
    of: Vec<Vec<usize>>,
    rates: usize,
    count: usize,
}

impl<'a> Coordinates<'a> {
    fn new(model: &'a Model) -> Self {
        let mut sorted: Vec<(usize, &Tie)> = model.ties.iter().enumerate().collect();
        sorted.sort_by_key(|(_, t)| t.far);
        let mut of = vec![Vec::new(); model.units];
        let (mut order, mut rates) = (Vec::new(), 0);
        for (place, (index, tie)) in sorted.into_iter().enumerate() {
            order.push((index, tie, rates));
            rates += tie.scaled.free().len();
            for unit in [tie.base, tie.incoming].into_iter().flatten() {
                if let Some(list) = of.get_mut(unit) {
                    list.push(place);
                }
            }
        }
        Self {
            order,
            of,
            rates,
            count: rates + model.columns(),
        }
    }

    /// The rates of a motion.
    fn of(&self, motion: &Sparse) -> Sparse {
        let units = motion.groups(6);
        let mut ties: Vec<usize> = units
            .iter()
            .filter_map(|u| self.of.get(*u))
            .flatten()
            .copied()
            .collect();
        ties.sort_unstable();
        ties.dedup();
        let mut out = Sparse::default();
        for (_, tie, first) in ties.iter().filter_map(|t| self.order.get(*t)) {
            let relative = motion.twist(tie.incoming) - motion.twist(tie.base);
            if relative.iter().any(|x| *x != 0.0) {
                for (k, rate) in tie.scaled.rates(&relative).into_iter().enumerate() {
                    out.push(first + k, rate);
                }
            }
        }
        out
    }

    /// What a coordinate is, by its place among them.
    fn driver(&self, row: usize) -> Driver {
        if row >= self.rates {
            return Driver::Entry(row - self.rates);
        }
        let after = self.order.partition_point(|(_, _, first)| *first <= row);
        // Ties without rates begin where the next one does.
        let found = after.checked_sub(1).and_then(|at| self.order.get(at));
        found.map_or(Driver::Entry(row), |(index, _, first)| {
            Driver::Joint(*index, row - first)
        })
    }
}
