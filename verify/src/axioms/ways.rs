//! Along which axes an assembly comes apart, and what stops its shafts.

use std::collections::{BTreeMap, BTreeSet};

use assemcad_axioms::apart::Apart;
use assemcad_axioms::asked::{self, END_PLAY_MM};
use assemcad_axioms::facts::{MateFacts, Side, Stop, Thrust, Unseen, Way, Ways};
use assemcad_axioms::indexed::Indexed;
use assemcad_model::mates::MateType;
use assemcad_model::ports::PortType;
use nalgebra::Vector3;

use super::limit::Limit;
use super::looker::{Looker, Pair};
use super::rays::PlacedFacets;
use super::sight::{Passage, Ring, SIDE};
use crate::terms::DEFAULT_TAU_MM3;

/// How much is looked at before the question is left open, in crossings of rays with triangles: tens of seconds,
/// a hundred times what a thousand parts took.
pub(super) const MOST_WORK: usize = 4_000_000_000;

/// What is in whose way along the axes of the mates and the world, as far as it takes to see the parts come
/// apart; along the diagonals too where they do not. And what stops each shaft along its own axis.
pub(super) fn look(
    facts: &Indexed,
    bodies: &[Option<PlacedFacets>],
    limit: &Limit,
    mut open: Vec<Unseen>,
) -> (Ways, Vec<Thrust>) {
    let passages = all_passages(facts);
    let clashes = clashes(facts, &passages);
    let mut looker = Looker::new(bodies, passages, limit);
    let there = facts.parts.iter().zip(bodies).enumerate();
    let there: Vec<usize> = there
        .filter(|(_, (p, b))| p.placement.is_some() && b.is_some())
        .map(|(i, _)| i)
        .collect();
    let name = |i: usize| facts.parts.get(i).map(|p| p.id.clone()).unwrap_or_default();
    // The place of each part among those that are there.
    let place: BTreeMap<usize, usize> = there.iter().copied().zip(0..).collect();
    let mut apart = Apart::new(there.len());
    let mut arrows: Vec<Vec<(usize, usize)>> = Vec::new();
    let mut axes: Vec<Way> = Vec::new();
    for axis in directions(facts) {
        if apart.is_done() {
            break;
        }
        let group = |i: usize| apart.of(*place.get(&i)?);
        let together =
            |(i, j): Pair| group(i).is_some() && group(i) == group(j) && !clashes.contains(&(i, j));
        let Some(found) = looker.stops(&axis, together) else {
            let left = apart.each().into_iter().filter(|g| g.len() > 1).flatten();
            open.extend(left.filter_map(|p| there.get(p)).map(|i| Unseen {
                part: name(*i),
                why: "so many parts are in line with each other that to look at all of them would take too long"
                    .to_owned(),
            }));
            break;
        };
        let each = found.iter().flat_map(|((i, j), s)| {
            let first = s.first.then_some((*i, *j));
            first.into_iter().chain(s.second.then_some((*j, *i)))
        });
        let stops: Vec<(usize, usize)> = each.collect();
        let arrow = |(part, by): &(usize, usize)| Some((*place.get(part)?, *place.get(by)?));
        arrows.push(stops.iter().filter_map(arrow).collect());
        axes.push(Way {
            axis: axis.into(),
            stops: stops
                .into_iter()
                .map(|(part, by)| Stop {
                    part: name(part),
                    by: name(by),
                    play_mm: 0.0,
                })
                .collect(),
        });
        // What came apart along one axis may come apart further along another.
        while arrows.iter().any(|a| apart.along(a)) {}
    }
    let whole = facts
        .parts
        .iter()
        .zip(bodies)
        .all(|(p, b)| p.placement.is_none() || b.is_some());
    let thrust = |carried: asked::Carried<'_>| {
        // A part that cannot be seen may be what holds the shaft.
        let axis = carried.shaft.world().filter(|_| whole);
        let axis = axis.map(|at| at.axes()[2]);
        let stops = axis.and_then(|axis| {
            let all = |pair: Pair| !clashes.contains(&pair);
            looker.stopped(&axis, all, END_PLAY_MM)
        });
        let stop = |part: usize, by: usize, play: Option<f64>| {
            play.map(|play_mm| Stop {
                part: name(part),
                by: name(by),
                play_mm,
            })
        };
        let named = |stops: Vec<_>| -> Vec<Stop> {
            let both = |((i, j), s): (Pair, super::sight::Stopped)| {
                [stop(i, j, s.first), stop(j, i, s.second)]
            };
            stops.into_iter().flat_map(both).flatten().collect()
        };
        Thrust {
            shaft: carried.shaft.part.id.clone(),
            stops: stops.map(named),
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

/// Two parts by their places, the earlier one first.
fn pair(facts: &Indexed, a: &str, b: &str) -> Option<Pair> {
    let (i, j) = (facts.place(a)?, facts.place(b)?);
    Some((i.min(j), i.max(j)))
}

/// The pairs that overlap more than their mates mean, whether the caller lets them pass or not: in each other as
/// they are, they would be in each other's way for ever.
fn clashes(facts: &Indexed, passages: &BTreeMap<Pair, Vec<Passage>>) -> BTreeSet<Pair> {
    let all = facts.measured.overlaps.iter().flatten();
    all.filter_map(|o| {
        let pair = pair(facts, &o.a, &o.b)?;
        let most = match passages.get(&pair) {
            None => DEFAULT_TAU_MM3,
            Some(_) => o.allowed_mm3,
        };
        (o.common_mm3? > most).then_some(pair)
    })
    .collect()
}

/// The axes to look along: those of the mates, the most frequent first, those of the world, then the
/// diagonals of the world's planes and octants.
fn directions(facts: &Indexed) -> Vec<Vector3<f64>> {
    let mut found: Vec<(Vector3<f64>, usize)> = Vec::new();
    // Mates of one direction are one step: what is the same to the last digit is found at once.
    let mut known: BTreeMap<[u64; 3], usize> = BTreeMap::new();
    let mut note = |axis: Vector3<f64>, count: usize| {
        let bits = <[f64; 3]>::from(axis).map(f64::to_bits);
        let at = *known.entry(bits).or_insert_with(|| {
            let near = |(a, _): &(Vector3<f64>, usize)| a.cross(&axis).norm() <= 1e-9;
            found.iter().position(near).unwrap_or(found.len())
        });
        match found.get_mut(at) {
            Some((_, n)) => *n += count,
            None => found.push((axis, count)),
        }
    };
    for m in &facts.mates {
        if let Some(at) = facts.sides(m).and_then(|(base, _)| base.world()) {
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

/// Where parts pass through each other by their mates: screws in their threads, what is pressed in, and the teeth
/// of helical gears, which are screwed out along their axis.
fn all_passages(facts: &Indexed) -> BTreeMap<Pair, Vec<Passage>> {
    let mut out: BTreeMap<Pair, Vec<Passage>> = BTreeMap::new();
    for m in &facts.mates {
        let pair = pair(facts, &m.base.part, &m.incoming.part);
        if let Some((pair, passage)) = pair.zip(passage(facts, m)) {
            out.entry(pair).or_default().push(passage);
        }
    }
    out
}

fn passage(facts: &Indexed, m: &MateFacts) -> Option<Passage> {
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

#[cfg(test)]
mod tests {
    use super::super::rays::tests::block;
    use super::{MOST_WORK, all_passages, directions, look};
    use crate::axioms::limit::Limit;
    use assemcad_axioms::indexed::Indexed;
    use serde_json::{Value, json};

    fn port(name: &str, port_type: &str, at: [f64; 3], params: Value) -> Value {
        let frame = json!({"origin": at, "x": [1, 0, 0], "z": [0, 0, 1]});
        json!({"name": name, "type": port_type, "frame": frame, "params": params})
    }

    fn facts(mate: &str, one: Value, two: Value) -> Indexed {
        let here = json!([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]]);
        let part = |id: &str, port: Value| json!({"id": id, "factory": "user.part", "ports": [port], "placement": here});
        let facts = serde_json::from_value(json!({
            "parts": [part("one", one), part("two", two)],
            "mates": [{
                "id": "m", "mate_type": mate, "base": {"ref": "one", "port": "p"},
                "incoming": {"ref": "two", "port": "p"},
            }],
        }));
        Indexed::new(facts.unwrap())
    }

    fn rings(facts: &Indexed) -> Vec<(f64, f64)> {
        let all = all_passages(facts);
        let rings = all
            .get(&(0, 1))
            .into_iter()
            .flatten()
            .flat_map(|p| &p.rings);
        rings.map(|r| (r.inner_mm, r.outer_mm)).collect()
    }

    #[test]
    fn threads_and_press_fits_pass_in_their_rings() {
        let thread = |t, length: &str, modelled: f64| {
            let params = json!({
                "diameter": 8, "pitch": 1.25, "hand": 1, length: 9, "modelled_diameter": modelled,
            });
            port("p", t, [0.0; 3], params)
        };
        let screwed = facts(
            "thread_engage",
            thread("THREAD_INTERNAL", "depth", 6.6),
            thread("THREAD_EXTERNAL", "length", 8.0),
        );
        assert_eq!(rings(&screwed), [(3.3, 4.0)]);
        let pressed = facts(
            "press_fit",
            port("p", "BORE", [0.0; 3], json!({"diameter": 20, "depth": 9})),
            port(
                "p",
                "SHAFT",
                [0.0; 3],
                json!({"diameter": 20.2, "length": 9}),
            ),
        );
        assert_eq!(rings(&pressed), [(10.0, 10.1)]);
    }

    #[test]
    fn helical_teeth_pass_where_both_gears_have_teeth() {
        let gears = |helix: f64| {
            let gear = |x: f64, helix: f64| {
                let params = json!({
                    "module": 2, "teeth": 20, "pressure_angle_deg": 20, "helix_angle_deg": helix,
                    "width": 10, "internal": 0,
                });
                port("p", "GEAR_MESH", [x, 0.0, 0.0], params)
            };
            facts("gear_mesh", gear(0.0, helix), gear(40.0, -helix))
        };
        // At 60 degrees the pitch circle of 20 teeth of module 2 is twice as wide: 40 mm, and 2.5 mm of teeth.
        let found = rings(&gears(60.0));
        assert_eq!(found.len(), 2);
        for (inner, outer) in found {
            assert!((inner - 37.5).abs() < 1e-9 && (outer - 42.5).abs() < 1e-9);
        }
        // Spur gears need none.
        assert!(rings(&gears(0.0)).is_empty());
    }

    #[test]
    fn a_lid_stops_what_is_under_it_and_one_axis_is_enough() {
        let on = |t: &str| port("p", t, [0.0; 3], json!({"extent_x": 1, "extent_y": 1}));
        let facts = facts("face_to_face", on("FLAT_FACE"), on("FLAT_FACE"));
        // The world's axes, the mate's own first, and ten diagonals.
        assert_eq!(directions(&facts).len(), 13);
        let lid = Some(block([0.0, 0.0, 10.0], [10.0, 10.0, 12.0]));
        let stone = Some(block([0.0; 3], [10.0; 3]));
        let (limit, _waiting) = Limit::new(MOST_WORK);
        let (ways, thrusts) = look(&facts, &[stone.clone(), lid], &limit, Vec::new());
        assert_eq!((ways.axes.len(), thrusts.len()), (1, 0));
        let stops = &ways.axes[0].stops;
        assert_eq!((stops.len(), stops[0].part.as_str()), (1, "one"));
        // A part that cannot be seen is in no group, and its caller says so.
        let (ways, _) = look(&facts, &[stone, None], &limit, Vec::new());
        assert!(ways.axes.is_empty());
    }
}
