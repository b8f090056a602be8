//! G-09: planets fit between sun and ring.

use std::collections::{BTreeMap, BTreeSet};

use super::Check;
use crate::gearing::{Gear, Pair, pairs};
use crate::geometry::{collinear, off_axis_mm};
use crate::indexed::Indexed;
use crate::ruling::{About, Ruling};

/// The planets of a stage share the axes of sun and ring, and find a gap in both at their places.
pub struct PlanetSpacing;

/// Of a pitch: what a planet may be off its gap.
const OFF: f64 = 1e-3;

/// A planet between a sun and a ring: its part, and the direction from the ring's axis in degrees.
struct Planet<'a> {
    part: &'a str,
    gear: Gear,
    at_deg: Option<f64>,
}

impl Check for PlanetSpacing {
    fn id(&self) -> &'static str {
        "planet_spacing"
    }

    fn axiom(&self) -> &'static str {
        "G-09"
    }

    fn run(&self, facts: &Indexed) -> Vec<Ruling> {
        let pairs = pairs(facts);
        let mut out = Vec::new();
        let mut rings: Vec<&str> = pairs
            .iter()
            .filter_map(|p| ring_and_planet(p))
            .map(|r| r.0)
            .collect();
        rings.sort_unstable();
        rings.dedup();
        let mut of: Pairs<'_> = BTreeMap::new();
        for p in &pairs {
            for gear in [&p.base.part.id, &p.incoming.part.id] {
                of.entry(gear).or_default().push(p);
            }
        }
        for ring in rings {
            // A sun meshes with a planet of the ring.
            let own = of.get(ring).into_iter().flatten();
            let planets = own
                .filter_map(|p| ring_and_planet(p))
                .map(|(_, planet)| planet);
            let inner = planets.filter_map(|planet| of.get(planet)).flatten();
            let suns: BTreeSet<&str> = inner
                .flat_map(|p| [p.base.part.id.as_str(), p.incoming.part.id.as_str()])
                .collect();
            for sun in suns {
                out.extend(stage(self.axiom(), &of, ring, sun));
            }
        }
        out
    }
}

/// The pairs of each gear, in their order.
type Pairs<'a> = BTreeMap<&'a str, Vec<&'a Pair<'a>>>;

/// The names of ring and planet, where a pair is one.
fn ring_and_planet<'a>(p: &Pair<'a>) -> Option<(&'a str, &'a str)> {
    let (base, incoming) = (p.base.part.id.as_str(), p.incoming.part.id.as_str());
    match (p.a.internal, p.b.internal) {
        (true, false) => Some((base, incoming)),
        (false, true) => Some((incoming, base)),
        _ => None,
    }
}

/// The verdict on the stage of a ring and a sun; none where no planet joins the two.
fn stage(axiom: &str, of: &Pairs<'_>, ring: &str, sun: &str) -> Option<Ruling> {
    let mut planets: Vec<Planet<'_>> = Vec::new();
    let mut ends: Option<(Gear, Gear)> = None;
    for p in of.get(ring).into_iter().flatten() {
        let Some((_, planet)) = ring_and_planet(p).filter(|(named, _)| *named == ring) else {
            continue;
        };
        let inner = of.get(planet).into_iter().flatten().find(|q| {
            let names = [q.base.part.id.as_str(), q.incoming.part.id.as_str()];
            !q.inside() && planet != sun && names.contains(&sun)
        });
        let Some(inner) = inner else {
            continue;
        };
        let (r, g, seen) = if p.a.internal {
            (p.a, p.b, p.seen)
        } else {
            (p.b, p.a, p.seen.map(|s| s.inverse()))
        };
        let s = if inner.base.part.id == sun {
            inner.a
        } else {
            inner.b
        };
        ends = Some((s, r));
        let at_deg = seen.map(|s| libm::atan2(s.origin().y, s.origin().x).to_degrees());
        planets.push(Planet {
            part: planet,
            gear: g,
            at_deg,
        });
    }
    let (s, r) = ends?;
    let sum = s.teeth + r.teeth;
    let mut wrong = Vec::new();
    for p in &planets {
        // Without profile shifts the pitch circles must fit: z_r = z_s + 2 z_p.
        let shifted = [s.shift, r.shift, p.gear.shift].iter().any(|x| *x != 0.0);
        if !shifted && (r.teeth - s.teeth - 2.0 * p.gear.teeth).abs() > 1e-9 {
            wrong.push(format!(
                "{} teeth of '{}' do not fill the space between {} and {}",
                p.gear.teeth, p.part, s.teeth, r.teeth
            ));
        }
    }
    if let Some(off) = axes_off(of, ring, sun) {
        wrong.push(format!("the axes of sun and ring are {off:.4} mm apart"));
    }
    // Two planets fit at the angle phi from each other where (z_s + z_r) phi / 360 degrees is whole
    // (for equal spacing: the sum is divisible by the number of planets; ANSI/AGMA 6123).
    let placed: Option<Vec<f64>> = planets.iter().map(|p| p.at_deg).collect();
    match (placed, planets.first()) {
        (Some(at), Some(first)) => {
            for (p, deg) in planets.iter().zip(&at).skip(1) {
                let turns = sum * (deg - first.at_deg.unwrap_or(*deg)) / 360.0;
                if (turns - libm::round(turns)).abs() > OFF {
                    wrong.push(format!("'{}' meets no gap at its place", p.part));
                }
            }
        }
        _ => {
            let n = planets.len() as f64;
            if (sum / n - libm::round(sum / n)).abs() > OFF {
                wrong.push(format!("{sum} is not divisible by {n} planets"));
            }
        }
    }
    let mut parts = vec![sun.to_owned(), ring.to_owned()];
    parts.extend(planets.iter().map(|p| p.part.to_owned()));
    let message = if wrong.is_empty() {
        format!("the planets between '{sun}' and '{ring}' find their gaps")
    } else {
        format!(
            "the stage of '{sun}' and '{ring}' does not go together: {}",
            wrong.join("; ")
        )
    };
    let placed = planets.iter().all(|p| p.at_deg.is_some());
    let v = Ruling::held(axiom, wrong.is_empty(), About::parts(parts), message)
        .value("teeth_of_sun_and_ring", sum)
        .value("planets", planets.len() as f64);
    Some(if placed {
        v
    } else {
        v.assuming("the planets are equally spaced: they have no place yet")
    })
}

/// How far the axes of sun and ring are apart, where they are not one line.
fn axes_off(of: &Pairs<'_>, ring: &str, sun: &str) -> Option<f64> {
    let side = |name: &str| {
        let mut ends = of.get(name)?.iter().flat_map(|p| [p.base, p.incoming]);
        ends.find(|s| s.part.id == name)
    };
    let seen = side(ring)?.sees(&side(sun)?)?;
    (!collinear(&seen)).then(|| off_axis_mm(&seen))
}
