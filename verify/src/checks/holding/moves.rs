//! What really moves: motions that every mate leaves free and no contact stops.

use assemcad_facts::{Free, Held, Rows, Way};
use assemcad_model::freedom::{Axis, Link};
use assemcad_model::spec::{Assembly, PartMotion, WorldAxis};
use assemcad_placing::Resolved;
use nalgebra::{DMatrix, DVector, Vector3, Vector6};

use super::loose::{body_of, claims};

type V = Vector3<f64>;

/// Singular values below this share of the largest count as zero.
const RANK: f64 = 1e-6;

/// What moves in a machine.
#[derive(Debug, Clone)]
pub(crate) struct Moves {
    /// Whether some contacts are known by their triangles alone, which may seem to stop what is free.
    pub(crate) approximate: bool,
    /// How many independent motions there are, without idle spins and what may lie loose.
    pub(crate) real: usize,
    /// What they are, in words, one for each body that moves by itself.
    pub(crate) words: Vec<String>,
    /// The parts that move so.
    pub(crate) parts: Vec<String>,
    /// The intended motions that none of them is, by their index.
    pub(crate) missing: Vec<usize>,
}

/// What moves; none where it could not be told.
pub(super) fn moves(
    spec: &Assembly,
    resolved: &Resolved,
    held: &Held,
    links: &[Link],
    spins: &[Option<Axis>],
) -> Option<Moves> {
    let bodies = body_of(held);
    let name = |part: &usize| resolved.name(*part);
    let mut out = Moves {
        approximate: held.approximate,
        real: 0,
        words: Vec::new(),
        parts: Vec::new(),
        missing: Vec::new(),
    };
    let mut met = vec![false; spec.intended_motions.len()];
    for free in &held.free {
        let basis = free.basis.as_ref()?;
        let real = allowed(free, links, &bodies, basis);
        if real.ncols() == 0 {
            continue;
        }
        let mut excused: Vec<DVector<f64>> = Vec::new();
        for (index, body) in free.bodies.iter().enumerate() {
            let parts = held
                .bodies
                .get(*body)
                .map(Vec::as_slice)
                .unwrap_or_default();
            for (met, meant) in met.iter_mut().zip(&spec.intended_motions) {
                if parts.iter().any(|p| name(p) == meant.part) {
                    *met |= makes(&real, index, meant);
                }
            }
            let of = |t: Vector6<f64>| {
                let mut all = DVector::zeros(real.nrows());
                all.rows_mut(6 * index, 6).copy_from(&t);
                all
            };
            let meant = |p: &usize| spec.intended_motions.iter().any(|m| m.part == name(p));
            if !parts.iter().any(meant) {
                excused.extend(idle(free, parts, spins).map(of));
            }
            // Every part that goes is stated as free: what is glued on a wheel says nothing of the wheel.
            let free_to = |p: &usize| spec.free.iter().find(|f| name(p) == f.part);
            if let Some(stated) = parts.first().and_then(free_to)
                && parts.iter().all(|p| free_to(p).is_some())
            {
                excused.extend(stated_twists(stated).into_iter().map(of));
            }
        }
        let count = real.ncols() - common(&real, &excused);
        out.real += count;
        if count == 0 {
            continue;
        }
        for (index, body) in free.bodies.iter().enumerate() {
            let parts = held
                .bodies
                .get(*body)
                .map(Vec::as_slice)
                .unwrap_or_default();
            let Some(word) = word(free, &real, index) else {
                continue;
            };
            let names: Vec<String> = parts.iter().map(name).collect();
            out.words.push(format!(
                "{} {word}",
                assemcad_model::name::listed(&names, 3)
            ));
            out.parts.extend(names);
        }
    }
    let missing = met.iter().enumerate().filter(|(_, met)| !**met);
    out.missing = missing.map(|(i, _)| i).collect();
    Some(out)
}

/// The motions of an island that break no mate.
fn allowed(
    free: &Free,
    links: &[Link],
    bodies: &std::collections::BTreeMap<usize, usize>,
    basis: &DMatrix<f64>,
) -> DMatrix<f64> {
    let mut rows: Vec<DVector<f64>> = Vec::new();
    for claim in claims(free, links, bodies) {
        for row in &claim.rows {
            let mut all = DVector::zeros(basis.nrows());
            for (body, sign) in [(claim.first, -1.0), (claim.second, 1.0)] {
                if let Some(b) = body {
                    let mut own = all.rows_mut(6 * b, 6);
                    own += row * (sign / row.norm());
                }
            }
            rows.push(basis.tr_mul(&all));
        }
    }
    if rows.is_empty() || basis.ncols() == 0 {
        return basis.clone();
    }
    let speeds = DMatrix::from_columns(&rows).transpose();
    basis * null_space(&speeds)
}

/// The null space of a matrix, as columns.
fn null_space(of: &DMatrix<f64>) -> DMatrix<f64> {
    let columns = of.ncols();
    // The triangle of a QR has the same null space and no more rows than columns.
    let square = if of.nrows() >= columns {
        of.clone().qr().r()
    } else {
        of.clone().resize_vertically(columns, 0.0)
    };
    let svd = square.svd(false, true);
    let largest = svd.singular_values.iter().copied().fold(0.0, f64::max);
    let Some(v_t) = svd.v_t else {
        return DMatrix::zeros(columns, 0);
    };
    let free: Vec<DVector<f64>> = svd
        .singular_values
        .iter()
        .enumerate()
        .filter(|(_, s)| **s <= RANK * largest.max(1.0))
        .map(|(i, _)| v_t.row(i).transpose())
        .collect();
    match free.is_empty() {
        true => DMatrix::zeros(columns, 0),
        false => DMatrix::from_columns(&free),
    }
}

/// The dimension of what a span has in common with some directions.
fn common(span: &DMatrix<f64>, others: &[DVector<f64>]) -> usize {
    if others.is_empty() {
        return 0;
    }
    let rank = |m: &DMatrix<f64>| {
        let svd = m.clone().svd(false, false);
        let largest = svd.singular_values.iter().copied().fold(0.0, f64::max);
        let clear = |s: &&f64| **s > RANK * largest.max(1e-9);
        svd.singular_values.iter().filter(clear).count()
    };
    let others = DMatrix::from_columns(others);
    let mut both = span
        .clone()
        .resize_horizontally(span.ncols() + others.ncols(), 0.0);
    both.columns_mut(span.ncols(), others.ncols())
        .copy_from(&others);
    (span.ncols() + rank(&others)).saturating_sub(rank(&both))
}

/// The turn of a body about an axis about which all its parts look the same.
fn idle<'a>(
    free: &'a Free,
    parts: &'a [usize],
    spins: &'a [Option<Axis>],
) -> impl Iterator<Item = Vector6<f64>> {
    let axes: Option<Vec<&Axis>> = parts
        .iter()
        .map(|p| spins.get(*p).and_then(Option::as_ref))
        .collect();
    let one = axes.and_then(|axes| {
        let first = *axes.first()?;
        let (point, along) = (V::from(first.point), V::from(first.direction));
        let same = axes.iter().all(|a| {
            let arm = V::from(a.point) - point;
            arm.cross(&along).norm() <= 1e-4 && V::from(a.direction).cross(&along).norm() <= 1e-6
        });
        same.then(|| free.scale.turn(&point, &along))
    });
    one.into_iter()
}

fn axis(of: WorldAxis) -> V {
    match of {
        WorldAxis::X => V::x(),
        WorldAxis::Y => V::y(),
        WorldAxis::Z => V::z(),
    }
}

/// The twists of a body that are stated as free.
fn stated_twists(stated: &PartMotion) -> Vec<Vector6<f64>> {
    let slide = stated.slides_along.map(axis);
    let turn = stated.turns_about.map(axis);
    let unit = |k: usize| {
        let mut t = Vector6::zeros();
        if let Some(slot) = t.get_mut(k) {
            *slot = 1.0;
        }
        t
    };
    match (slide, turn) {
        (None, None) => (0..6).map(unit).collect(),
        (slide, turn) => {
            let mut out: Vec<Vector6<f64>> = slide.iter().map(Rows::slide).collect();
            if let Some(t) = turn {
                // About any line of that direction: what it does to the middle lies across it.
                out.push(Rows::about(&t));
                let (x, y) = (t.yzx(), t.zxy());
                out.extend([Rows::slide(&x), Rows::slide(&y)]);
            }
            out
        }
    }
}

/// Whether a body can make a stated motion, the others following.
fn makes(real: &DMatrix<f64>, body: usize, meant: &PartMotion) -> bool {
    let own = real.rows(6 * body, 6);
    let (turn, slide) = (own.rows(0, 3), own.rows(3, 3));
    let can = |held: DMatrix<f64>, wanted: DMatrix<f64>| {
        let left = null_space(&held);
        (wanted * left).amax() > 1e-4
    };
    let rows = |all: &[V]| {
        DMatrix::from_fn(all.len(), 3, |i, j| {
            all.get(i)
                .and_then(|v| v.get(j))
                .copied()
                .unwrap_or_default()
        })
    };
    let across = |a: V| rows(&[a.yzx(), a.zxy()]);
    let along = |a: V| rows(&[a]);
    match (meant.slides_along, meant.turns_about) {
        (Some(a), _) => {
            let a = axis(a);
            let mut held = DMatrix::zeros(5, real.ncols());
            held.rows_mut(0, 3).copy_from(&turn);
            held.rows_mut(3, 2).copy_from(&(across(a) * slide));
            can(held, along(a) * slide)
        }
        (None, Some(a)) => {
            let a = axis(a);
            can(across(a) * turn, along(a) * turn)
        }
        (None, None) => own.amax() > 1e-4,
    }
}

/// What a body does in words: its simplest motion, the others following; none where it stands still.
fn word(free: &Free, real: &DMatrix<f64>, body: usize) -> Option<String> {
    let own: DMatrix<f64> = real.rows(6 * body, 6).into_owned();
    if own.amax() <= 1e-4 {
        return None;
    }
    let svd = own.clone().svd(true, false);
    let largest = svd.singular_values.iter().copied().fold(0.0, f64::max);
    let u = svd.u?;
    let span: Vec<Vector6<f64>> = svd
        .singular_values
        .iter()
        .enumerate()
        .filter(|(_, s)| **s > 1e-6 * largest)
        .map(|(i, _)| Vector6::from_iterator(u.column(i).iter().copied()))
        .collect();
    let lies = |t: &Vector6<f64>| {
        let inside: Vector6<f64> = span.iter().map(|b| b * b.dot(t)).sum();
        (t - inside).norm() <= 1e-4 * t.norm()
    };
    let simple = free.ways(body).find(|(_, t)| lies(t));
    Some(match simple {
        Some((Way::Slide(along), _)) => {
            format!("slides along {}", super::loose::direction(along.into()))
        }
        Some((Way::Turn(_, along), _)) => {
            format!("turns about {}", super::loose::direction(along.into()))
        }
        None => "moves".to_owned(),
    })
}
