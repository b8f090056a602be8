//! What the checks of walls, ways, tools and seats want to have measured on the solids: asked of the kernel's
//! workers as triangles, and looked at with rays.

use std::collections::BTreeSet;
use std::sync::Arc;

use assemcad_axioms::asked;
use assemcad_axioms::facts::{Reach, Thrust, TipSeat, Unseen, Wall, Ways};
use assemcad_axioms::indexed::Indexed;
use assemcad_geometry::Asker;
use assemcad_kernel::asked::Body;
use assemcad_model::angle::sin_cos_deg;
use assemcad_model::frame::Placement;
use assemcad_model::probe::{Probe, Test};
use assemcad_placing::solids::once_per_recipe;
use assemcad_placing::{Assembled, Resolved};
use futures::future::join_all;
use nalgebra::Vector3;

use super::limit::Limit;
use super::rays::{Facets, PlacedFacets};
use super::tree::{Box3, Tree};
use super::ways;

/// How far triangles may be off a surface: this share of the solid's diagonal, between these limits in mm.
const DEFLECTION: f64 = 2e-4;
const DEFLECTION_MM: (f64, f64) = (0.002, 0.02);

/// How far they may be off in direction, in degrees.
const DEFLECTION_DEG: f64 = 20.0;

/// At which shares of a bore's depth its wall is measured: off the middle, where set screws and oil holes are.
const HEIGHTS: [f64; 3] = [0.137, 0.521, 0.863];

/// How many rays measure the wall at each height, and the angle of the first one: the walls of blocks are
/// thinnest on the axes, and rays on them would meet edges of triangles.
const AROUND: u32 = 48;
const FIRST_DEG: f64 = 0.37;

/// How far from its stated radius a bore's wall may be met, in mm; beyond it the ray went out through an
/// opening.
const WALL_MM: f64 = 0.05;

/// Rays of a tool: rings at these shares of its radius, of so many rays each.
const RINGS: [f64; 4] = [0.02, 0.35, 0.7, 0.97];
const ON_RING: u32 = 12;

/// How far before the fastener's end the rays of its tool begin to count, in mm.
const CLEAR_MM: f64 = 0.05;

/// How far under the round of a shaft the tip of a set screw is sunk, in mm: more than any tolerance.
const SUNK_MM: f64 = 0.05;

/// Measures what the checks ask for, and notes it in the facts.
pub(super) async fn measure(door: Asker<'_>, assembled: &Assembled<'_>, facts: Indexed) -> Indexed {
    let bodies = bodies(door, assembled).await;
    let tips = tips(door, assembled.resolved, &facts).await;
    // Much work, which is not for the threads that answer; and for nobody, when this is dropped.
    let (limit, waiting) = Limit::new(ways::MOST_WORK);
    let facts = Arc::new(facts);
    let shared = Arc::clone(&facts);
    let looked = tokio::task::spawn_blocking(move || Looked::new(&shared, &bodies, &limit)).await;
    drop(waiting);
    let mut facts = Arc::try_unwrap(facts).unwrap_or_else(|shared| (*shared).clone());
    let measured = facts.measured_mut();
    measured.tips = Some(tips);
    // What was lost on the way was not measured, and the checks say so.
    if let Ok(looked) = looked {
        measured.walls = looked.walls;
        measured.reaches = looked.reaches;
        measured.ways = Some(looked.ways);
        measured.thrusts = Some(looked.thrusts);
    }
    facts
}

/// What is looked at with rays.
struct Looked {
    walls: Option<Vec<Wall>>,
    reaches: Option<Vec<Reach>>,
    ways: Ways,
    thrusts: Vec<Thrust>,
}

impl Looked {
    fn new(facts: &Indexed, bodies: &[Option<PlacedFacets>], limit: &Limit) -> Self {
        let unseen = facts.parts.iter().zip(bodies).filter(|(p, b)| {
            // Parts without a place are another check's.
            p.placement.is_some() && b.is_none()
        });
        let open: Vec<Unseen> = unseen
            .map(|(p, _)| Unseen {
                part: p.id.clone(),
                why: "its solid or its triangles could not be made".to_owned(),
            })
            .collect();
        let walls = walls(facts, bodies, limit);
        let reaches = reaches(facts, bodies, limit);
        let (ways, thrusts) = ways::look(facts, bodies, limit, open);
        Self {
            walls,
            reaches,
            ways,
            thrusts,
        }
    }
}

/// The placed parts as triangles. Parts of one recipe are asked once.
async fn bodies(door: Asker<'_>, assembled: &Assembled<'_>) -> Vec<Option<PlacedFacets>> {
    let meshes = once_per_recipe(assembled.resolved, assembled.built, |part, b| async move {
        let size = Vector3::from(b.max) - Vector3::from(b.min);
        let deflection_mm = (DEFLECTION * size.norm()).clamp(DEFLECTION_MM.0, DEFLECTION_MM.1);
        let whole = Body::Whole {
            recipe: part.made.solid.clone(),
        };
        let mesh = door.mesh(&whole, deflection_mm, DEFLECTION_DEG).await;
        Some(Arc::new(Facets::new(mesh.ok()??.as_ref(), deflection_mm)))
    })
    .await;
    let body = |i: usize, facets: Option<&Option<Arc<Facets>>>| {
        Some(PlacedFacets::new(
            facets?.as_ref()?,
            &assembled.placements.of(i)?,
        ))
    };
    let each = meshes.iter().enumerate();
    each.map(|(i, mesh)| body(i, mesh.as_deref())).collect()
}

fn body<'a>(
    facts: &Indexed,
    bodies: &'a [Option<PlacedFacets>],
    part: &str,
) -> Option<&'a PlacedFacets> {
    bodies.get(facts.place(part)?)?.as_ref()
}

/// A point about the z axis of a frame in the world.
fn polar(at: &Placement, radius: f64, deg: f64, z: f64) -> Vector3<f64> {
    let (sin, cos) = sin_cos_deg(deg);
    Vector3::from(at.point([radius * cos, radius * sin, z]))
}

/// The walls around the bores: rays from the axis outward meet the bore's wall and then its other side.
fn walls(facts: &Indexed, bodies: &[Option<PlacedFacets>], limit: &Limit) -> Option<Vec<Wall>> {
    let wall = |bore: &asked::Bore<'_>| {
        let body = body(facts, bodies, &bore.hole.part.id)?;
        let at = bore.hole.world()?;
        let (radius, depth) = (
            bore.hole.port.value("diameter") / 2.0,
            bore.hole.port.value("depth"),
        );
        let (mut least, mut met, mut rays) = (f64::INFINITY, 0, 0);
        for height in HEIGHTS {
            let z = -height * depth;
            let origin = polar(&at, 0.0, 0.0, z);
            for n in 0..AROUND {
                let deg = FIRST_DEG + 360.0 * f64::from(n) / f64::from(AROUND);
                let along = polar(&at, 1.0, deg, z) - origin;
                rays += 1;
                let crossings = body.crossings(&origin, &along);
                let into = crossings.iter().find(|c| c.enters);
                let Some(into) = into.filter(|c| (c.at - radius).abs() <= WALL_MM) else {
                    continue;
                };
                let out = crossings.iter().find(|c| !c.enters && c.at > into.at);
                if let Some(out) = out {
                    met += 1;
                    least = least.min(out.at - into.at);
                }
            }
        }
        Some(Wall {
            part: bore.hole.part.id.clone(),
            port: bore.hole.port.name.clone(),
            least_mm: least.is_finite().then_some(least),
            rays,
            met,
        })
    };
    let found = limit.each(&asked::bores(facts), |bore| Some(wall(bore)))?;
    Some(found.into_iter().flatten().collect())
}

/// How far the tools of the fasteners come: rays from the fastener's end on, in the tool's cylinder.
fn reaches(facts: &Indexed, bodies: &[Option<PlacedFacets>], limit: &Limit) -> Option<Vec<Reach>> {
    let placed = facts.parts.iter().zip(bodies).enumerate();
    let placed = placed.filter(|(_, (part, _))| part.placement.is_some());
    let (mut at, mut balls) = (Vec::new(), Vec::new());
    let mut unseen: BTreeSet<&str> = BTreeSet::new();
    for (i, (part, body)) in placed {
        match body {
            Some(body) => {
                at.push(i);
                balls.push(body.ball());
            }
            None => {
                unseen.insert(&part.id);
            }
        }
    }
    let tree = Tree::new(&balls);
    // The parts that may be in a cylinder, in their order.
    let near = |from: &Vector3<f64>, to: &Vector3<f64>, radius: f64| {
        let about = |p: &Vector3<f64>, by: f64| [p.x + by, p.y + by, p.z + by];
        let ends = [from, to].into_iter();
        let cylinder = ends.fold(Box3::NONE, |b, p| {
            b.with(about(p, -radius)).with(about(p, radius))
        });
        let mut out: Vec<usize> = Vec::new();
        tree.visit(|b| b.meets(&cylinder), |k| out.extend(at.get(k).copied()));
        out.sort_unstable();
        out
    };
    let reach = |tool: &asked::Tool<'_>| {
        let own = body(facts, bodies, &tool.fastener.id)?;
        let at = tool.fastener.world(tool.port)?;
        let origin = at.origin();
        let along = -at.axes()[2];
        let end = own.reach(&origin, &along);
        let mine = |part: &str| part == tool.fastener.id || tool.inside.contains(&part);
        let known = unseen.iter().all(|part| mine(part));
        let mut nearest: Option<(f64, &str)> = None;
        let start = origin + along * end;
        let stop = start + along * (tool.length_mm + 2.0 * CLEAR_MM);
        for i in near(&start, &stop, tool.diameter_mm / 2.0) {
            let (Some(part), Some(Some(other))) = (facts.parts.get(i), bodies.get(i)) else {
                continue;
            };
            if mine(&part.id) {
                continue;
            }
            // What lies wholly beside the tool, or behind the fastener's end, is in no tool's way.
            let beside = other.beside(&origin, &along, tool.diameter_mm / 2.0);
            if beside || other.reach(&origin, &along) <= end + CLEAR_MM {
                continue;
            }
            for ring in RINGS {
                for n in 0..ON_RING {
                    let deg = FIRST_DEG + 360.0 * f64::from(n) / f64::from(ON_RING);
                    let from = polar(&at, ring * tool.diameter_mm / 2.0, deg, 0.0)
                        + along * (end + CLEAR_MM);
                    let Some(first) = other.crossings(&from, &along).first().copied() else {
                        continue;
                    };
                    // A ray that first goes out began within the part.
                    let free = if first.enters {
                        first.at + CLEAR_MM
                    } else {
                        0.0
                    };
                    if free < tool.length_mm && nearest.is_none_or(|(n, _)| free < n) {
                        nearest = Some((free, &part.id));
                    }
                }
            }
        }
        let free = nearest.map_or(tool.length_mm, |(free, _)| free);
        Some(Reach {
            part: tool.fastener.id.clone(),
            // An obstacle is one whatever else could not be seen.
            free_mm: (known || nearest.is_some()).then_some(free),
            by: nearest.map(|(_, by)| by.to_owned()),
        })
    };
    let found = limit.each(&asked::tools(facts), |tool| Some(reach(tool)))?;
    Some(found.into_iter().flatten().collect())
}

/// What lies under the tips of set screws, asked of the exact solid of the shaft.
async fn tips(door: Asker<'_>, resolved: &Resolved, facts: &Indexed) -> Vec<TipSeat> {
    let each = asked::tips(facts).into_iter().map(|tip| async move {
        // The facts have the parts in the same order.
        let part = resolved.parts.get(facts.place(&tip.shaft.part.id)?)?;
        // The tip's frame in the shaft's own.
        let at = tip.shaft.part.placement?.inverse() * tip.screw.world()?;
        let normal = at.direction([0.0, 0.0, -1.0]);
        let quarter = tip.screw.port.value("diameter") / 4.0;
        let across = [
            [0.0, 0.0],
            [quarter, 0.0],
            [-quarter, 0.0],
            [0.0, quarter],
            [0.0, -quarter],
        ];
        let plane = |[x, y]: [f64; 2]| Test::Plane {
            point: at.point([x, y, 0.0]),
            normal,
        };
        let free = Test::Out {
            point: at.point([0.0, 0.0, -SUNK_MM]),
        };
        let probes: Vec<Probe> = core::iter::once(free)
            .chain(across.map(plane))
            .map(|test| Probe {
                shows: "what a set screw stands on".to_owned(),
                test,
            })
            .collect();
        let answers = door.probe(&part.made.solid, &probes).await.ok()?;
        let (free, planes) = answers.split_first()?;
        let seen = tip.shaft.sees(&tip.screw)?.origin();
        let under = tip.shaft.port.value("diameter") / 2.0 - libm::hypot(seen.x, seen.y);
        Some(TipSeat {
            mate: tip.mate.id.clone(),
            flat: planes.iter().all(|a| a.held),
            sunk: free.held && under > SUNK_MM,
        })
    });
    join_all(each).await.into_iter().flatten().collect()
}
