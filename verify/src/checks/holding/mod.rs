//! The check `holding`: what holds each part is in the solids, not in the mates.
//!
//! `facts` finds from the contacts alone which motions nothing stops. A motion that some mate says it holds and
//! that no contact, thread, press fit or bond stops is a finding: a face across a gap joins nothing, a plate without
//! screws lies there, a hub without a ring slides off.

use std::collections::{BTreeMap, BTreeSet};

use assemcad_factories::failure::diagnostic;
use assemcad_facts::{Coupled, Free, Held, PairMeetings, Placed, Thread, held};
use assemcad_geometry::Asker;
use assemcad_geometry::narrow::meet::REACH_MM;
use assemcad_model::diagnostic::{Code, Diagnostic};
use assemcad_model::freedom::Link;
use assemcad_model::mates::MateType;
use assemcad_model::ports::PortType;
use assemcad_model::report::{MateFacts, Verdict};
use assemcad_model::spec::Assembly;
use assemcad_placing::linkage::system;
use assemcad_placing::solids::near_pairs;
use assemcad_placing::{Assembled, Resolved};
use futures::future::join_all;

use crate::results::Results;

mod fits;
mod guides;
mod holes;
mod loose;
mod moves;
mod play;
mod teeth;

pub(crate) use moves::Moves;

const CHECK: &str = "holding";

const HOW: &str = "motions that no contact of the placed solids stops, held against those that the mates say they hold; \
    threads, press fits, stated bonds and what lies in the grip of a screw are one body";

/// Finds the parts that nothing holds, and what really moves; none where that could not be told.
pub(crate) async fn check(
    door: Asker<'_>,
    spec: &Assembly,
    assembled: &Assembled<'_>,
    mates: &[MateFacts],
    results: &mut Results,
) -> Option<Moves> {
    let resolved = assembled.resolved;
    let cases = resolved.parts.len();
    // What the mates say can be held against facts only where they hold; else that is told elsewhere.
    let Ok(system) = system(resolved, assembled.placements) else {
        results.check(CHECK, Verdict::Indeterminate, cases, HOW);
        return None;
    };
    let (pairs, open) = meetings(door, assembled).await;
    let mut verdict = if open.is_empty() {
        Verdict::Pass
    } else {
        Verdict::Indeterminate
    };
    for (parts, d) in open {
        results.find(Verdict::Indeterminate, CHECK, parts, d);
    }
    let claims = Claims::new(resolved, &system.links, mates);
    let threads = threads(assembled);
    let ground: Vec<usize> = resolved.root.into_iter().collect();
    let parts = resolved.parts.len();
    // What has no place is joined to nothing, which is told as that.
    let there = |part: usize| assembled.placements.of(part).is_some();
    let mut links = system.links;
    links.retain(|l| there(l.base) && there(l.incoming));
    let count = parts;
    let volumes: Vec<f64> = (0..parts)
        .map(|p| assembled.built(p).map_or(0.0, |b| b.volume))
        .collect();
    let spins: Vec<_> = system.bodies.iter().map(|b| b.spin).collect();
    // Much work where many parts are loose: not for the threads that answer.
    let looked = tokio::task::spawn_blocking(move || {
        let held = held(&Placed {
            parts: count,
            ground: &ground,
            pairs: &pairs,
            threads: &threads,
            pressed: &claims.pressed,
            bonded: &claims.bonded,
            driven: &claims.driven,
            coupled: &claims.coupled,
            volumes: &volumes,
        });
        let loose = loose::loose(&held, &links);
        let rattles = play::rattles(&held, &pairs);
        (held, loose, rattles, pairs, links)
    })
    .await;
    let Ok((held, loose, rattles, pairs, links)) = looked else {
        results.check(CHECK, Verdict::Indeterminate, cases, HOW);
        return None;
    };
    for free in held.free.iter().filter(|f| f.basis.is_none()) {
        let names = names(resolved, &held, &free.bodies);
        let d = Diagnostic::error(
            Code::Indeterminate,
            "assembly",
            "what holds these parts could not be told: too many of them move against each other",
        );
        verdict = verdict.and(Verdict::Indeterminate);
        results.find(Verdict::Indeterminate, CHECK, names, d);
    }
    let mut told = loose::told(spec, resolved, &held, &loose);
    told.extend(fits::told(resolved, &held));
    told.extend(guides::told(assembled, &pairs, mates));
    told.extend(teeth::told(assembled));
    told.extend(play::told(resolved, &rattles));
    told.extend(holes::told(door, assembled, &held, &pairs).await);
    for finding in told {
        verdict = verdict.and(finding.verdict);
        results.findings.push(finding);
    }
    let moves = match verdict {
        Verdict::Indeterminate => None,
        _ => moves::moves(spec, resolved, &held, &links, &spins),
    };
    let motions: usize = held.free.iter().map(motions_of).sum();
    let how = format!(
        "{HOW}; {} bodies, {motions} motions that no contact stops",
        held.bodies.len()
    );
    results.check(CHECK, verdict, cases, &how);
    moves
}

fn motions_of(free: &Free) -> usize {
    free.basis.as_ref().map_or(0, |b| b.ncols())
}

/// The parts of some bodies.
fn names(resolved: &Resolved, held: &Held, bodies: &[usize]) -> Vec<String> {
    let parts = bodies.iter().filter_map(|b| held.bodies.get(*b)).flatten();
    parts.map(|p| resolved.name(*p)).collect()
}

/// A pair of parts of which it is not known how they meet, and why.
type Open = (Vec<String>, Diagnostic);

/// How all pairs meet that are near each other.
async fn meetings(door: Asker<'_>, assembled: &Assembled<'_>) -> (Vec<PairMeetings>, Vec<Open>) {
    let resolved = assembled.resolved;
    let boxes: Vec<_> = (0..resolved.parts.len())
        .map(|i| assembled.world_box(i))
        .collect();
    let near = near_pairs(&boxes, REACH_MM);
    let found = join_all(near.into_iter().map(|(a, b)| async move {
        let (one, two) = (assembled.solid(a)?, assembled.solid(b)?);
        Some((a, b, door.meetings(&one, &two).await))
    }))
    .await;
    let (mut pairs, mut open) = (Vec::new(), Vec::new());
    for (a, b, found) in found.into_iter().flatten() {
        match found {
            Ok(meetings) if meetings.is_empty() => {}
            Ok(meetings) => pairs.push(PairMeetings { a, b, meetings }),
            Err(f) => {
                let (one, two) = (resolved.name(a), resolved.name(b));
                let d = diagnostic(&f, &format!("parts '{one}' and '{two}'"));
                open.push((vec![one, two], d));
            }
        }
    }
    (pairs, open)
}

/// What mates state of how parts are held: each counts only where the solids show it.
struct Claims {
    pressed: BTreeSet<(usize, usize)>,
    bonded: BTreeSet<(usize, usize)>,
    driven: BTreeSet<(usize, usize)>,
    coupled: Vec<Coupled>,
}

impl Claims {
    fn new(resolved: &Resolved, links: &[Link], mates: &[MateFacts]) -> Self {
        let pairs = |of: &dyn Fn(&assemcad_placing::ResolvedMate) -> bool| {
            let chosen = resolved.mates.iter().filter(|m| of(m));
            chosen.map(|m| (m.base, m.incoming)).collect()
        };
        let shown: BTreeMap<&str, Option<Verdict>> =
            mates.iter().map(|m| (m.mate.as_str(), m.contact)).collect();
        let coupled = links.iter().filter_map(|link| {
            let (at, direction) = link.pitch()?;
            let meets = shown.get(link.name.as_str()).copied().flatten() == Some(Verdict::Pass);
            meets.then(|| Coupled {
                a: link.base,
                b: link.incoming,
                at: at.into(),
                direction: direction.into(),
            })
        });
        Self {
            pressed: pairs(&|m| m.mate.mate_type == MateType::PressFit),
            bonded: pairs(&|m| m.joint().bonded()),
            driven: pairs(&|m| {
                m.mate.mate_type == MateType::ThreadEngage
                    && !m
                        .mate
                        .mate_type
                        .kind()
                        .freedom(&m.joint())
                        .twists
                        .is_empty()
            }),
            coupled: coupled.collect(),
        }
    }
}

/// The threads of the placed parts.
fn threads(assembled: &Assembled<'_>) -> Vec<Thread> {
    let mut out = Vec::new();
    for (part, resolved) in assembled.resolved.parts.iter().enumerate() {
        let Some(at) = assembled.placements.of(part) else {
            continue;
        };
        for port in resolved.ports() {
            let external = match port.port_type {
                PortType::ThreadExternal => true,
                PortType::ThreadInternal => false,
                _ => continue,
            };
            let frame = at.frame(&port.frame);
            out.push(Thread {
                part,
                external,
                point: frame.origin.into(),
                direction: frame.z.into(),
                diameter_mm: port.value("diameter"),
                lead_mm: port.value("hand") * port.value("pitch"),
                modelled_mm: port.value("modelled_diameter"),
            });
        }
    }
    out
}
