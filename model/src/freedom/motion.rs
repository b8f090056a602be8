//! A basis of the free motions in which each has a name.
//!
//! The basis is the null space's reduced echelon form over these coordinates, in this order: the spins of bodies
//! about their own axes; the rates of the links along what they leave free, links nearest to the ground first,
//! then by name; the bodies' twists. Each motion then has one coordinate, its driver, at 1, at which all others
//! stand still: a chain of joints comes out joint by joint, a mechanism as driven by its joint at the ground.

use nalgebra::{DMatrix, DVector, Vector3};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::island::{Island, Model, twist_of};
use super::linear::{null_space, rank};
use super::rigid::{angular, linear, stack};
use super::{Lasting, System};
use crate::report::rounded;

/// A free motion.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Motion {
    /// What moves how, in words.
    pub name: String,
    /// How many independent motions this is: six for an island that nothing holds, else one.
    pub count: usize,
    /// Whether it is only the turning of bodies about axes of their own, which is no motion of the machine.
    pub idle: bool,
    /// Whether it goes on.
    pub lasting: Lasting,
    /// What each moving body does while the driver, the first body's joint, moves by a radian or a millimetre.
    pub bodies: Vec<BodyMotion>,
}

/// What a body does in a motion, against the ground.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct BodyMotion {
    /// The body.
    pub body: String,
    /// Turning, sliding or both.
    pub kind: Kind,
    /// Unit direction of the axis or of the slide, its first component that is not 0 positive.
    pub direction: [f64; 3],
    /// The axis' point nearest to the world's origin, in mm; none for a slide.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub through_mm: Option<[f64; 3]>,
    /// Turn about the direction, in radians.
    pub turn_rad: f64,
    /// Travel along the direction, in mm.
    pub travel_mm: f64,
}

/// What a twist is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Kind {
    /// A rotation about an axis.
    Turn,
    /// A translation.
    Slide,
    /// A rotation about an axis and a translation along it.
    Screw,
}

/// Free motions as twists of all moving bodies, in the island's units.
pub(super) struct Basis {
    pub(super) motions: Vec<DVector<f64>>,
    /// How many of them, the first ones, are idle spins.
    pub(super) idle: usize,
    /// Whether a motion's driver is a travel.
    travels: Vec<bool>,
}

/// A driver's rate below this share of the fastest coordinate leads to another choice of driver.
const SLOW: f64 = 1e-3;
/// Below this share of the largest component a body stands still.
const STILL: f64 = 1e-7;

pub(super) fn basis(
    model: &Model,
    system: &System,
    matrix: &DMatrix<f64>,
    free: &DMatrix<f64>,
) -> Basis {
    let mut left: Vec<DVector<f64>> = free
        .column_iter()
        .map(|c| c.into_owned() / c.amax().max(f64::MIN_POSITIVE))
        .collect();
    let mut out = Basis {
        motions: idle(model, system, matrix),
        idle: 0,
        travels: Vec::new(),
    };
    out.idle = out.motions.len();
    out.travels = vec![false; out.idle];
    for k in 0..out.idle {
        let Some(mut v) = out.motions.get(k).cloned() else {
            break;
        };
        let pivot = v.iamax();
        v /= v[pivot];
        let others = out.motions.iter_mut().enumerate().filter(|(i, _)| *i != k);
        for other in others.map(|(_, o)| o).chain(&mut left) {
            let by = other[pivot];
            *other -= &v * by;
        }
        if let Some(slot) = out.motions.get_mut(k) {
            *slot = v;
        }
    }
    for slow in [SLOW, STILL] {
        let mut row = 0;
        while out.motions.len() < free.ncols() {
            let rates: Vec<DVector<f64>> = left.iter().map(|v| coordinates(model, v)).collect();
            if rates.iter().all(|r| row >= r.len()) {
                break;
            }
            let mut best: Option<(usize, f64)> = None;
            for (i, (rate, v)) in rates.iter().zip(&left).enumerate() {
                let fast = rate[row].abs() > slow * rate.amax() && v.amax() > STILL;
                let most = best.map_or(0.0, |(_, b)| b);
                if fast && rate[row].abs() > most * (1.0 + 1e-9) {
                    best = Some((i, rate[row].abs()));
                }
            }
            if let Some((i, _)) = best {
                let by = rates.get(i).map_or(1.0, |r| r[row]);
                let v = left.remove(i) / by;
                let own = coordinates(model, &v)[row];
                let clear = |other: &mut DVector<f64>| {
                    let by = coordinates(model, other)[row] / own;
                    *other -= &v * by;
                };
                left.iter_mut().for_each(clear);
                out.motions.iter_mut().skip(out.idle).for_each(clear);
                out.travels.push(travel(model, row));
                out.motions.push(v);
            }
            row += 1;
        }
    }
    out
}

/// Motions in which bodies turn about axes of their own and nothing else moves.
fn idle(model: &Model, system: &System, matrix: &DMatrix<f64>) -> Vec<DVector<f64>> {
    let mut spins = Vec::new();
    for (i, body) in model.moving.iter().enumerate() {
        if let Some(axis) = system.bodies.get(*body).and_then(|b| b.spin) {
            let (p, d) = (Vector3::from(axis.point), Vector3::from(axis.direction));
            let p = (p - model.middle) / model.length;
            let mut v = DVector::zeros(model.columns());
            v.fixed_rows_mut::<6>(6 * i)
                .copy_from(&stack(&d, &p.cross(&d)));
            spins.push(v);
        }
    }
    if spins.is_empty() {
        return spins;
    }
    let spins = DMatrix::from_columns(&spins);
    let work = matrix * &spins;
    // With a 1 of its own beside it the rank does not count what is mere rounding.
    let (m, n) = work.shape();
    let mut beside = DMatrix::zeros(m + 1, n + 1);
    beside.view_mut((0, 0), (m, n)).copy_from(&work);
    beside[(m, n)] = 1.0;
    let held = rank(&beside).map_or(n, |r| r.rank.saturating_sub(1));
    let free = spins * null_space(&work, held);
    free.column_iter().map(|c| c.into_owned()).collect()
}

/// The order of the links: by their farther body as found from the ground, then by name.
fn order(model: &Model) -> Vec<usize> {
    let mut order: Vec<usize> = (0..model.links.len()).collect();
    order.sort_by_key(|l| model.links.get(*l).map(|(a, b, _)| (*a).max(*b)));
    order
}

/// The coordinates of a motion, in the order in which they are chosen as drivers.
fn coordinates(model: &Model, motion: &DVector<f64>) -> DVector<f64> {
    let mut out = Vec::new();
    for l in order(model) {
        if let Some((base, incoming, link)) = model.links.get(l) {
            out.extend(link.rates(&(twist_of(motion, *incoming) - twist_of(motion, *base))));
        }
    }
    out.extend(motion.iter());
    DVector::from_vec(out)
}

/// Whether a coordinate is a travel.
fn travel(model: &Model, mut row: usize) -> bool {
    for l in order(model) {
        if let Some((_, _, link)) = model.links.get(l) {
            let free = link.free();
            match free.get(row) {
                Some(t) => return angular(t).norm() == 0.0,
                None => row -= free.len(),
            }
        }
    }
    row % 6 >= 3
}

/// The motions of an island by name, and that of the island as a whole where nothing holds it.
pub(super) fn named(
    island: &Island,
    model: &Model,
    system: &System,
    basis: &Basis,
    lasting: Option<&[Lasting]>,
) -> Vec<Motion> {
    let name = |b: &usize| system.bodies.get(*b).map_or("", |b| b.name.as_str());
    let mut out = Vec::new();
    if island.floating {
        let names: Vec<&str> = island.bodies.iter().map(name).collect();
        let verb = if names.len() == 1 {
            "floats"
        } else {
            "float as one"
        };
        out.push(Motion {
            name: format!("{} {verb}: nothing holds them to the root", quoted(&names))
                .replace("floats: nothing holds them", "floats: nothing holds it"),
            count: 6,
            idle: false,
            lasting: Lasting::True,
            bodies: Vec::new(),
        });
    }
    for (i, (motion, travels)) in basis.motions.iter().zip(&basis.travels).enumerate() {
        let unit = if *travels { 1.0 / model.length } else { 1.0 };
        let idle = i < basis.idle;
        let moving = model.moving.iter().enumerate();
        let bodies: Vec<BodyMotion> = moving
            .filter_map(|(k, b)| {
                let t = twist_of(motion, Some(k));
                (t.amax() > STILL * motion.amax()).then(|| body_motion(name(b), model, &(t * unit)))
            })
            .collect();
        out.push(Motion {
            name: words(&bodies, idle),
            count: 1,
            idle,
            lasting: lasting.map_or(Lasting::True, |l| {
                l.get(i).copied().unwrap_or(Lasting::Indeterminate)
            }),
            bodies,
        });
    }
    out
}

fn body_motion(body: &str, model: &Model, t: &nalgebra::Vector6<f64>) -> BodyMotion {
    let (turn, slide) = (angular(t), linear(t));
    let turns = turn.norm() > STILL * slide.norm();
    let along = if turns { turn } else { slide };
    let mut direction = along.normalize();
    if direction
        .iter()
        .find(|c| c.abs() > 1e-9)
        .is_some_and(|c| *c < 0.0)
    {
        direction = -direction;
    }
    let travel = slide.dot(&direction) * model.length;
    // The axis' point nearest to the middle is turn x slide / turn^2; then the one nearest to the origin.
    let through = turns.then(|| {
        let p = model.middle + turn.cross(&slide) * (model.length / turn.norm_squared());
        <[f64; 3]>::from(p - direction * direction.dot(&p)).map(rounded)
    });
    let screws = turns && travel.abs() > 1e-6 * model.length * turn.norm();
    BodyMotion {
        body: body.to_owned(),
        kind: match (turns, screws) {
            (true, false) => Kind::Turn,
            (true, true) => Kind::Screw,
            _ => Kind::Slide,
        },
        direction: <[f64; 3]>::from(direction).map(rounded),
        through_mm: through,
        turn_rad: if turns {
            rounded(turn.dot(&direction))
        } else {
            0.0
        },
        travel_mm: if turns && !screws {
            0.0
        } else {
            rounded(travel)
        },
    }
}

fn words(bodies: &[BodyMotion], idle: bool) -> String {
    let mut groups: Vec<(&BodyMotion, Vec<&str>)> = Vec::new();
    for b in bodies {
        let same = |g: &BodyMotion| {
            BodyMotion {
                body: b.body.clone(),
                ..g.clone()
            } == *b
        };
        match groups.iter_mut().find(|(g, _)| same(g)) {
            Some((_, names)) => names.push(&b.body),
            None => groups.push((b, vec![&b.body])),
        }
    }
    let lead = bodies.first().map_or(1.0, |b| b.turn_rad);
    let said = groups.iter().map(|(b, names)| {
        let one = names.len() == 1;
        let verb = |word: &str| {
            if one {
                format!("{word}s")
            } else {
                word.to_owned()
            }
        };
        let through = b.through_mm.map_or_else(String::new, |p| {
            format!(
                " through [{}, {}, {}]",
                three(p[0]),
                three(p[1]),
                three(p[2])
            )
        });
        let (who, axis) = (quoted(names), axis_name(&b.direction));
        if idle {
            return format!("{who} {} idly about {axis}{through}", verb("spin"));
        }
        let rate = if lead == 0.0 || b.turn_rad == 0.0 || (b.turn_rad - lead).abs() < 1e-6 {
            String::new()
        } else {
            format!(", {} times", three(b.turn_rad / lead))
        };
        match b.kind {
            Kind::Turn => format!("{who} {} about {axis}{through}{rate}", verb("turn")),
            Kind::Slide => format!("{who} {} along {axis}", verb("slide")),
            Kind::Screw => {
                let lead_mm = three(b.travel_mm / b.turn_rad * 2.0 * core::f64::consts::PI);
                format!(
                    "{who} {} about {axis}{through} by {lead_mm} mm a turn{rate}",
                    verb("screw")
                )
            }
        }
    });
    said.collect::<Vec<_>>().join("; ")
}

fn quoted(names: &[&str]) -> String {
    let quoted: Vec<String> = names.iter().map(|n| format!("'{n}'")).collect();
    quoted.join(", ")
}

fn three(x: f64) -> f64 {
    libm::round(x * 1e3) / 1e3 + 0.0
}

fn axis_name(d: &[f64; 3]) -> String {
    match d.map(|c| libm::round(c * 1e6)) {
        [1e6, 0.0, 0.0] => "x".to_owned(),
        [0.0, 1e6, 0.0] => "y".to_owned(),
        [0.0, 0.0, 1e6] => "z".to_owned(),
        _ => format!("[{}, {}, {}]", three(d[0]), three(d[1]), three(d[2])),
    }
}
