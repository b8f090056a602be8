//! Free motions in words.

use nalgebra::Vector6;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::island::Island;
use super::model::Model;
use super::motion::{Basis, STILL};
use super::rigid::{angular, linear};
use super::sparse::Sparse;
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
    /// How many bodies move beside the hundred that are listed.
    #[serde(default, skip_serializing_if = "is_none")]
    pub more_bodies: usize,
}

/// How many bodies of a motion are listed; how many a sentence names that do the same.
const MOST_BODIES: usize = 100;
const MOST_NAMES: usize = 20;

fn is_none(n: &usize) -> bool {
    *n == 0
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

/// The motions of an island by name, and that of the island as a whole where nothing holds it.
pub(super) fn named(
    island: &Island,
    model: &Model,
    system: &System,
    basis: &Basis,
    lasting: &[Lasting],
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
            more_bodies: 0,
        });
    }
    for (i, (motion, driver)) in basis.motions.iter().zip(&basis.drivers).enumerate() {
        let idle = i < basis.idle;
        let travels = driver.travels(model);
        let (bodies, more) = first_motions(model, system, motion, travels, MOST_BODIES);
        let mut name = words(&bodies, idle);
        if more > 0 {
            name.push_str(&format!("; and {more} more bodies move"));
        }
        out.push(Motion {
            name,
            count: 1,
            idle,
            lasting: lasting.get(i).copied().unwrap_or(Lasting::Indeterminate),
            bodies,
            more_bodies: more,
        });
    }
    out
}

/// What the bodies do in a motion whose driver moves by a radian or, where it travels, by a millimetre.
pub(super) fn body_motions(
    model: &Model,
    system: &System,
    motion: &Sparse,
    travels: bool,
) -> Vec<BodyMotion> {
    first_motions(model, system, motion, travels, usize::MAX).0
}

/// What the first of the bodies do, and how many more move.
fn first_motions(
    model: &Model,
    system: &System,
    motion: &Sparse,
    travels: bool,
    most: usize,
) -> (Vec<BodyMotion>, usize) {
    let scale = if travels { 1.0 / model.length } else { 1.0 };
    let still = STILL * motion.amax();
    let mut moving: Vec<(usize, usize, Vector6<f64>)> = Vec::new();
    for unit in motion.groups(6) {
        let t = motion.twist(Some(unit));
        if t.amax() > still {
            let bodies = model.bodies.get(unit).into_iter().flatten();
            moving.extend(bodies.map(|(place, body)| (*place, *body, t * scale)));
        }
    }
    moving.sort_unstable_by_key(|(place, _, _)| *place);
    let of = |(_, body, t): &(usize, usize, Vector6<f64>)| {
        Some(body_motion(&system.bodies.get(*body)?.name, model, t))
    };
    let said: Vec<BodyMotion> = moving.iter().take(most).filter_map(of).collect();
    let more = moving.len() - said.len();
    (said, more)
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

pub(super) fn words(bodies: &[BodyMotion], idle: bool) -> String {
    let mut groups: Vec<(&BodyMotion, Vec<&str>)> = Vec::new();
    for b in bodies {
        let same = |g: &BodyMotion| {
            (g.kind, g.direction, g.through_mm) == (b.kind, b.direction, b.through_mm)
                && (g.turn_rad, g.travel_mm) == (b.turn_rad, b.travel_mm)
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
    let first = names.iter().take(MOST_NAMES);
    let quoted: Vec<String> = first.map(|n| format!("'{n}'")).collect();
    let quoted = quoted.join(", ");
    match names.len().saturating_sub(MOST_NAMES) {
        0 => quoted,
        more => format!("{quoted} and {more} more"),
    }
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
