//! Along which axes an assembly comes apart, and what stops its shafts.

use assemcad_axioms::apart::groups;
use assemcad_axioms::asked;
use assemcad_axioms::facts::{Facts, Side, Stop, Thrust, Unseen, Way, Ways};
use assemcad_model::mates::MateType;
use assemcad_model::ports::PortType;
use nalgebra::Vector3;

use super::rays::Body;
use super::sight::{Looker, Passage, Ring, SIDE, Stopped};

/// How many pairs are looked at, one axis each, before the question is left open: some seconds of work.
const MOST_LOOKS: usize = 4000;

/// What is in whose way along the axes of the mates and the world, as far as it takes to see the parts come
/// apart; along the diagonals too where they do not. And what stops each shaft along its own axis.
pub(super) fn look(
    facts: &Facts,
    bodies: &[Option<Body>],
    mut open: Vec<Unseen>,
) -> (Ways, Vec<Thrust>) {
    let passages = |i: usize, j: usize| passages(facts, i, j);
    let mut looker = Looker::new(bodies, &passages, MOST_LOOKS);
    let parts: Vec<String> = facts
        .parts
        .iter()
        .zip(bodies)
        .filter(|(p, b)| p.placement.is_some() && b.is_some())
        .map(|(p, _)| p.id.clone())
        .collect();
    let mut axes: Vec<Way> = Vec::new();
    for axis in directions(facts) {
        let left = groups(&parts, &axes);
        let together: Vec<(usize, usize)> = left.iter().flat_map(|g| pairs(facts, g)).collect();
        if together.is_empty() {
            break;
        }
        match stops(facts, &mut looker, &axis, &together) {
            Some(stops) => axes.push(Way {
                axis: axis.into(),
                stops,
            }),
            None => {
                open.extend(
                    left.iter()
                        .filter(|g| g.len() > 1)
                        .flatten()
                        .map(|p| Unseen {
                            part: p.clone(),
                            why: format!(
                                "more than {MOST_LOOKS} looks at pairs of parts would be needed"
                            ),
                        }),
                );
                break;
            }
        }
    }
    let all = pairs(facts, &parts);
    let thrust = |carried: asked::Carried<'_>| {
        let known = |part: &Side<'_>| {
            let axis = part.world()?.axes()[2];
            // A part that cannot be seen may be what holds the shaft.
            let whole = facts
                .parts
                .iter()
                .all(|p| p.placement.is_none() || parts.contains(&p.id));
            whole.then_some(axis)
        };
        Thrust {
            shaft: carried.shaft.part.id.clone(),
            stops: known(&carried.shaft).and_then(|axis| stops(facts, &mut looker, &axis, &all)),
        }
    };
    let thrusts = asked::shafts_in_bearings(facts).into_iter().map(thrust);
    let thrusts = thrusts.collect();
    let ways = Ways {
        axes,
        open,
        rays_a_side: u32::try_from(SIDE).unwrap_or(u32::MAX),
    };
    (ways, thrusts)
}

/// The pairs of some parts, by index.
fn pairs(facts: &Facts, parts: &[String]) -> Vec<(usize, usize)> {
    let index = |id: &String| facts.parts.iter().position(|p| p.id == *id);
    let at: Vec<usize> = parts.iter().filter_map(index).collect();
    let each = at.iter().enumerate();
    each.flat_map(|(n, i)| at.iter().skip(n + 1).map(move |j| (*i, *j)))
        .collect()
}

/// What stops what of some pairs along an axis; none where not all of them could be looked at. Pairs that
/// clash are left out: in each other as they are, they would be in each other's way for ever.
fn stops(
    facts: &Facts,
    looker: &mut Looker<'_>,
    axis: &Vector3<f64>,
    pairs: &[(usize, usize)],
) -> Option<Vec<Stop>> {
    let clash = |a: &str, b: &str| {
        let both = |x: &str, y: &str| (x == a && y == b) || (x == b && y == a);
        let mut all = facts.measured.overlaps.iter().flatten();
        all.any(|o| both(&o.a, &o.b) && o.common_mm3.is_some_and(|c| c > o.allowed_mm3))
    };
    let mut out = Vec::new();
    for (i, j) in pairs {
        let (a, b) = (&facts.parts.get(*i)?.id, &facts.parts.get(*j)?.id);
        if clash(a, b) {
            continue;
        }
        let Stopped { first, second } = looker.pair(axis, *i, *j)?;
        let stop = |part: &String, by: &String, play_mm| Stop {
            part: part.clone(),
            by: by.clone(),
            play_mm,
        };
        out.extend(first.map(|play| stop(a, b, play)));
        out.extend(second.map(|play| stop(b, a, play)));
    }
    Some(out)
}

/// The axes to look along: those of the mates, the most frequent first, those of the world, then the
/// diagonals of the world's planes and octants.
fn directions(facts: &Facts) -> Vec<Vector3<f64>> {
    let mut found: Vec<(Vector3<f64>, usize)> = Vec::new();
    let mut note = |axis: Vector3<f64>, count: usize| match found
        .iter_mut()
        .find(|(a, _)| a.cross(&axis).norm() <= 1e-9)
    {
        Some((_, n)) => *n += count,
        None => found.push((axis, count)),
    };
    for m in &facts.mates {
        if let Some(at) = facts.side(&m.base).and_then(|s| s.world()) {
            note(at.axes()[2], 1);
        }
    }
    for axis in [Vector3::z(), Vector3::x(), Vector3::y()] {
        note(axis, 0);
    }
    // Stable: among equals the order of the specification.
    found.sort_by_key(|(_, n)| core::cmp::Reverse(*n));
    let mut out: Vec<Vector3<f64>> = found.into_iter().map(|(a, _)| a).collect();
    for [x, y, z] in DIAGONALS {
        out.push(Vector3::new(x, y, z).normalize());
    }
    out
}

const DIAGONALS: [[f64; 3]; 10] = [
    [1.0, 1.0, 0.0],
    [1.0, -1.0, 0.0],
    [1.0, 0.0, 1.0],
    [1.0, 0.0, -1.0],
    [0.0, 1.0, 1.0],
    [0.0, 1.0, -1.0],
    [1.0, 1.0, 1.0],
    [1.0, 1.0, -1.0],
    [1.0, -1.0, 1.0],
    [1.0, -1.0, -1.0],
];

/// Where two parts pass through each other by their mates: screws in their threads, what is pressed in, and
/// the teeth of helical gears, which are screwed out along their axis.
fn passages(facts: &Facts, i: usize, j: usize) -> Vec<Passage> {
    let (Some(a), Some(b)) = (facts.parts.get(i), facts.parts.get(j)) else {
        return Vec::new();
    };
    let both = facts.mates.iter().filter(|m| m.has(&a.id) && m.has(&b.id));
    both.filter_map(|m| {
        let (base, incoming) = facts.sides(m)?;
        let rings = match m.mate_type {
            MateType::ThreadEngage => {
                let of = |s: &Side<'_>, name: &str| s.port.value(name) / 2.0;
                let modelled = "modelled_diameter";
                let inner = of(&base, modelled).min(of(&incoming, modelled));
                let outer = of(&base, "diameter").max(of(&incoming, "diameter"));
                vec![ring(&base, inner, outer)?]
            }
            MateType::PressFit => {
                let (one, two) = (base.port.value("diameter"), incoming.port.value("diameter"));
                vec![ring(&base, one.min(two) / 2.0, one.max(two) / 2.0)?]
            }
            MateType::GearMesh => vec![teeth(&base)?, teeth(&incoming)?],
            _ => return None,
        };
        Some(Passage { rings })
    })
    .collect()
}

fn ring(side: &Side<'_>, inner_mm: f64, outer_mm: f64) -> Option<Ring> {
    let at = side.world()?;
    let [_, _, axis] = at.axes();
    Some(Ring {
        point: at.origin(),
        axis,
        inner_mm,
        outer_mm,
    })
}

/// Where the teeth of a helical gear are: a module and a quarter on both sides of the pitch circle, as far as
/// the profile shift moves them. Spur gears come apart along their axis as they are.
fn teeth(side: &Side<'_>) -> Option<Ring> {
    if side.port.port_type != PortType::GearMesh || side.port.value("helix_angle_deg") == 0.0 {
        return None;
    }
    let (_, cos) = assemcad_model::angle::sin_cos_deg(side.port.value("helix_angle_deg"));
    let module = side.port.value("module");
    let pitch = module * side.port.value("teeth") / (2.0 * cos);
    let height = module * (1.25 + side.port.value("profile_shift").abs());
    ring(side, pitch - height, pitch + height)
}
