//! The scene of a picture: bodies, frames, legend and notes.

use std::collections::BTreeMap;

use assemcad_geometry::Asker;
use assemcad_kernel::protocol::{Instance, Product};
use assemcad_model::diagnostic::Faults;
use assemcad_model::report::rounded;
use assemcad_placing::Partial;
use assemcad_placing::partial::nowhere;
use assemcad_placing::products::products;
use assemcad_placing::resolved::part_unknown;
use assemcad_placing::solids::{Box3, box_of, build_all};
use assemcad_render::{ALARM, Body, Entry, Look, Mark, Panel, Sheet};

use super::bodies::{Common, Found, Side, Solids, common_solid, shifted};
use super::wanted::Wanted;
use super::{explode, words};

/// The colour of the second of two equal parts that stand out.
const OTHER: [f64; 3] = [0.80, 0.62, 0.33];

/// The legend's colour of surroundings.
const GREY: [f64; 3] = [0.82, 0.83, 0.85];

/// How far triangles may be from the surface, in pixels.
const DEFLECTION_PX: f64 = 0.25;

/// A sheet, and what is missing on it.
pub(super) struct Scene {
    pub(super) sheet: Sheet,
    pub(super) missing: Vec<String>,
}

/// The two parts that stand out, their looks and what they have in common.
struct Pair {
    indices: [usize; 2],
    common: Option<Common>,
    /// Whether they overlap is not known.
    unknown: Option<String>,
}

/// Makes the scene of a picture.
pub(super) async fn scene(
    door: Asker<'_>,
    id: &str,
    part: &Partial,
    wanted: &Wanted,
) -> Result<Scene, Faults> {
    let resolved = &part.resolved;
    let mut missing = part.missing.clone();
    let built = build_all(door, resolved).await;
    let mut boxes: Vec<Option<Box3>> = Vec::new();
    for (i, (found, of)) in built.iter().zip(&resolved.parts).enumerate() {
        boxes.push(match (found, part.placements.of(i)) {
            (Ok(b), Some(at)) => Some(box_of(b, &at)),
            (Ok(_), None) => None,
            (Err(d), _) => {
                missing.push(format!("{}: {}", of.id, d.message));
                None
            }
        });
    }
    let (products, instances) = products(resolved, &part.placements);
    let solids = Solids {
        part,
        products: &products,
        instances: &instances,
        boxes: &boxes,
        deflection: deflection(wanted, explode::diagonal(&boxes)),
    };
    let pair = match &wanted.highlight {
        Some(names) => Some(pair_of(door, &solids, names).await?),
        None => None,
    };
    let moved = explode::offsets(part, &boxes, wanted.explode);
    let mut drawn: BTreeMap<bool, Vec<Found>> = BTreeMap::new();
    let mut panels = Vec::new();
    for camera in &wanted.views {
        let side = side(wanted, camera.eye().toward);
        let key = side.is_some_and(|(_, upper)| upper);
        if let std::collections::btree_map::Entry::Vacant(slot) = drawn.entry(key) {
            slot.insert(solids.surfaces(door, side).await);
        }
        let surfaces = drawn.get(&key).map(Vec::as_slice).unwrap_or_default();
        let bodies = bodies(&solids, surfaces, &moved, pair.as_ref());
        panels.push(Panel {
            title: words::title(id, wanted, camera),
            eye: camera.eye(),
            bodies,
            marks: marks(&solids, &moved, wanted, pair.as_ref()),
            in_place: wanted.explode == 0.0,
        });
    }
    // Each list has all parts, in their order.
    for (found, instance) in drawn.values().flatten().zip(instances.iter().cycle()) {
        let known = |m: &String| m.starts_with(&format!("{}: ", instance.name));
        if let Err(d) = found
            && !missing.iter().any(known)
        {
            missing.push(format!("{}: {}", instance.name, d.message));
        }
    }
    let mut notes = words::notes(&missing);
    notes.extend(pair.iter().filter_map(|p| p.unknown.clone()));
    let overlaps = wanted.section.is_some() && wanted.explode == 0.0;
    let sheet = Sheet {
        width: wanted.width,
        height: wanted.height,
        panels,
        legend: legend(&solids, pair.as_ref(), overlaps),
        notes,
    };
    Ok(Scene { sheet, missing })
}

/// Finds the two parts that stand out.
async fn pair_of(
    door: Asker<'_>,
    solids: &Solids<'_>,
    names: &[String; 2],
) -> Result<Pair, Faults> {
    let parts = &solids.part.resolved.parts;
    let mut faults = Vec::new();
    let mut indices = Vec::new();
    for name in names {
        match parts.iter().position(|p| p.id == *name) {
            None => faults.push(part_unknown(parts, name, "highlight")),
            Some(i) if solids.boxes.get(i).is_none_or(Option::is_none) => {
                faults.push(nowhere(name, "highlight"));
            }
            Some(i) => indices.push(i),
        }
    }
    let &[a, b] = indices.as_slice() else {
        return Err(faults);
    };
    let found = match (solids.solid(a), solids.solid(b)) {
        (Some(a), Some(b)) => common_solid(door, a, b, solids.deflection).await,
        _ => Ok(None),
    };
    let (common, unknown) = match found {
        Ok(common) => (common, None),
        Err(d) => (
            None,
            Some(format!(
                "whether the two overlap is not known: {}",
                d.message
            )),
        ),
    };
    Ok(Pair {
        indices: [a, b],
        common,
        unknown,
    })
}

/// The side of the section that is taken away: the one on which the viewer is.
fn side(wanted: &Wanted, toward: [f64; 3]) -> Option<Side> {
    let section = wanted.section?;
    let upper = toward.get(section.axis).is_none_or(|t| *t >= 0.0);
    Some((section, upper))
}

fn color(instance: &Instance, products: &[Product]) -> [f64; 3] {
    products
        .get(instance.solid)
        .map(|p| p.color)
        .unwrap_or_default()
}

/// The colours of a pair: the parts' own, told apart where these are equal.
fn pair_colors(solids: &Solids<'_>, pair: &Pair) -> [[f64; 3]; 2] {
    let own = pair.indices.map(|i| {
        solids
            .instances
            .get(i)
            .map(|instance| color(instance, solids.products))
            .unwrap_or_default()
    });
    if own[0] == own[1] {
        [own[0], OTHER]
    } else {
        own
    }
}

fn bodies(
    solids: &Solids<'_>,
    surfaces: &[Found],
    moved: &[[f64; 3]],
    pair: Option<&Pair>,
) -> Vec<Body> {
    let mut out = Vec::new();
    for (i, (instance, surface)) in solids.instances.iter().zip(surfaces).enumerate() {
        let (Some(at), Ok(Some(surface))) = (solids.part.placements.of(i), surface) else {
            continue;
        };
        let placement = shifted(&at, moved.get(i).copied().unwrap_or_default());
        let mut body = Body {
            surface: surface.clone(),
            placement,
            color: color(instance, solids.products),
            look: Look::Solid,
            fit: true,
        };
        if let Some(pair) = pair {
            match pair.indices.iter().position(|p| *p == i) {
                Some(which) => {
                    let [first, second] = pair_colors(solids, pair);
                    body.color = if which == 0 { first } else { second };
                    if pair.common.is_some() {
                        body.look = Look::Glass;
                    }
                }
                None => {
                    body.look = Look::Ghost;
                    body.fit = false;
                }
            }
        }
        out.push(body);
    }
    if let Some(common) = pair.and_then(|p| p.common.as_ref()) {
        out.push(Body {
            surface: common.surface.clone(),
            placement: assemcad_model::frame::Placement::IDENTITY,
            color: ALARM,
            look: Look::Solid,
            fit: true,
        });
    }
    out
}

fn marks(
    solids: &Solids<'_>,
    moved: &[[f64; 3]],
    wanted: &Wanted,
    pair: Option<&Pair>,
) -> Vec<Mark> {
    let mut out = Vec::new();
    for (i, part) in solids.part.resolved.parts.iter().enumerate() {
        let Some(at) = solids.part.placements.of(i) else {
            continue;
        };
        if pair.is_some_and(|p| !p.indices.contains(&i)) {
            continue;
        }
        let at = shifted(&at, moved.get(i).copied().unwrap_or_default());
        if wanted.frames {
            out.push(Mark {
                frame: at.frame(&assemcad_model::frame::Frame::WORLD),
                label: part.id.clone(),
                large: true,
            });
        }
        if wanted.ports {
            out.extend(part.ports().iter().map(|port| Mark {
                frame: at.frame(&port.frame),
                label: format!("{}:{}", part.id, port.name),
                large: false,
            }));
        }
    }
    out
}

fn legend(solids: &Solids<'_>, pair: Option<&Pair>, cut: bool) -> Vec<Entry> {
    let shown = |i: &usize| solids.boxes.get(*i).is_some_and(Option::is_some);
    let name = |i: usize| {
        solids
            .instances
            .get(i)
            .map(|instance| instance.name.clone())
            .unwrap_or_default()
    };
    if let Some(pair) = pair {
        let mut out: Vec<Entry> = pair
            .indices
            .iter()
            .zip(pair_colors(solids, pair))
            .map(|(i, color)| Entry {
                color,
                label: name(*i),
            })
            .collect();
        out.push(match &pair.common {
            Some(common) => Entry {
                color: ALARM,
                label: format!("in both: {} mm3", rounded(common.volume)),
            },
            None => Entry {
                color: [1.0; 3],
                label: "nothing in both".to_owned(),
            },
        });
        if pair.unknown.is_some() {
            out.pop();
        }
        if solids.instances.len() > 2 {
            out.push(Entry {
                color: GREY,
                label: "all other parts".to_owned(),
            });
        }
        return out;
    }
    // Equal parts have one colour and one line.
    let of = |(product, which): (usize, &Product)| {
        let names: Vec<String> = solids
            .instances
            .iter()
            .enumerate()
            .filter(|(i, instance)| instance.solid == product && shown(i))
            .map(|(_, instance)| instance.name.clone())
            .collect();
        (!names.is_empty()).then(|| Entry {
            color: which.color,
            label: words::list(&names, 3),
        })
    };
    let overlap = cut.then(|| Entry {
        color: ALARM,
        label: "overlap, where any".to_owned(),
    });
    let products = solids.products.iter().enumerate();
    products.filter_map(of).chain(overlap).collect()
}

/// How far triangles may be from the surface, in mm: a share of a pixel, in steps so that pictures of
/// nearly the same size share their triangles.
fn deflection(wanted: &Wanted, diagonal: f64) -> f64 {
    let side = f64::from(wanted.width.min(wanted.height));
    let mm_per_px = wanted
        .views
        .iter()
        .filter_map(|v| v.eye().aim)
        .map(|(_, seen_mm)| seen_mm / side)
        .fold(diagonal / side, f64::min);
    // Finer than this the triangles of a whole machine would not fit into memory.
    let wanted = (DEFLECTION_PX * mm_per_px)
        .clamp(diagonal * 2e-5, 10.0)
        .max(1e-4);
    let mut step = 16.0;
    while step > wanted {
        step /= 2.0;
    }
    step
}
