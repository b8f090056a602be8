//! Along which axes an assembly comes apart, and what stops its shafts.

use assemcad_axioms::apart::groups;
use assemcad_axioms::asked;
use assemcad_axioms::facts::{Facts, Side, Stop, Thrust, Unseen, Way, Ways};
use assemcad_model::mates::MateType;
use assemcad_model::ports::PortType;
use nalgebra::Vector3;

use super::rays::Facets;
use super::sight::{Looker, Passage, Ring, SIDE, Stopped};
use crate::terms::DEFAULT_TAU_MM3;

/// How many pairs are looked at, one axis each, before the question is left open: some seconds of work.
const MOST_LOOKS: usize = 4000;

/// What is in whose way along the axes of the mates and the world, as far as it takes to see the parts come
/// apart; along the diagonals too where they do not. And what stops each shaft along its own axis.
pub(super) fn look(
    facts: &Facts,
    bodies: &[Option<Facets>],
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
/// overlap more than their mates mean are left out, whether the caller lets them pass or not: in each other as
/// they are, they would be in each other's way for ever.
fn stops(
    facts: &Facts,
    looker: &mut Looker<'_>,
    axis: &Vector3<f64>,
    pairs: &[(usize, usize)],
) -> Option<Vec<Stop>> {
    let clash = |i: usize, j: usize, a: &str, b: &str| {
        let both = |x: &str, y: &str| (x == a && y == b) || (x == b && y == a);
        let mut all = facts.measured.overlaps.iter().flatten();
        let most = |allowed: f64| match passages(facts, i, j).is_empty() {
            true => DEFAULT_TAU_MM3,
            false => allowed,
        };
        all.any(|o| both(&o.a, &o.b) && o.common_mm3.is_some_and(|c| c > most(o.allowed_mm3)))
    };
    let mut out = Vec::new();
    for (i, j) in pairs {
        let (a, b) = (&facts.parts.get(*i)?.id, &facts.parts.get(*j)?.id);
        if clash(*i, *j, a, b) {
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

#[cfg(test)]
mod tests {
    use super::super::rays::tests::block;
    use super::{directions, look, passages};
    use assemcad_axioms::facts::Facts;
    use serde_json::{Value, json};

    fn port(name: &str, port_type: &str, at: [f64; 3], params: Value) -> Value {
        let frame = json!({"origin": at, "x": [1, 0, 0], "z": [0, 0, 1]});
        json!({"name": name, "type": port_type, "frame": frame, "params": params})
    }

    fn facts(mate: &str, one: Value, two: Value) -> Facts {
        let here = json!([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]]);
        let part = |id: &str, port: Value| json!({"id": id, "factory": "user.part", "ports": [port], "placement": here});
        serde_json::from_value(json!({
            "parts": [part("one", one), part("two", two)],
            "mates": [{
                "id": "m", "mate_type": mate, "base": {"ref": "one", "port": "p"},
                "incoming": {"ref": "two", "port": "p"},
            }],
        }))
        .unwrap()
    }

    fn rings(facts: &Facts) -> Vec<(f64, f64)> {
        let all = passages(facts, 1, 0);
        let rings = all.iter().flat_map(|p| &p.rings);
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
        let (ways, thrusts) = look(&facts, &[stone.clone(), lid], Vec::new());
        assert_eq!((ways.axes.len(), thrusts.len()), (1, 0));
        let stops = &ways.axes[0].stops;
        assert_eq!((stops.len(), stops[0].part.as_str()), (1, "one"));
        // A part that cannot be seen is in no group, and its caller says so.
        let (ways, _) = look(&facts, &[stone, None], Vec::new());
        assert!(ways.axes.is_empty());
    }
}
