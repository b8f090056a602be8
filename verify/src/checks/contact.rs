//! The check `contact`: mated parts touch where their mate promises it.
//!
//! Parts that are pulled apart never collide, so that contact has to be shown, not only clearance:
//! faces and line-to-line fits by the area that faces of both parts have in common in the stated plane or
//! about the stated axis (a shared edge has none); press fits and threads by their overlap; gears by the
//! flanks that meet when one gear is turned by the backlash window either way.

use std::collections::BTreeMap;

use assemcad_factories::failure::diagnostic;
use assemcad_geometry::{Asker, PlacedSolid};
use assemcad_kernel::contact::{Touch, Where};
use assemcad_model::diagnostic::{Code, Diagnostic};
use assemcad_model::frame::Placement;
use assemcad_model::mates::Contact;
use assemcad_model::report::{Finding, MateFacts, PairFacts, Verdict, rounded};
use assemcad_placing::solids::moved;
use assemcad_placing::{Placements, Resolved, ResolvedMate};
use futures::future::join_all;
use serde_json::{Map, Value, json};

use crate::checks::interference::SAMPLES;
use crate::results::Results;

/// The smallest area that counts as contact, in mm2: far below any seat, far above rounding.
const LEAST_MM2: f64 = 1e-6;

/// What was found of a promised contact.
struct Shown {
    verdict: Verdict,
    area_mm2: Option<f64>,
    values: Map<String, Value>,
    diagnostic: Option<Diagnostic>,
}

/// Checks the contact that every mate promises whose parts are placed, and notes its area.
pub(crate) async fn check(
    door: Asker<'_>,
    (resolved, placements): (&Resolved, &Placements),
    pairs: &[PairFacts],
    facts: &mut [MateFacts],
    tau: f64,
    results: &mut Results,
) {
    let pairs = &by_names(pairs);
    let found = join_all(resolved.mates.iter().map(|m| async move {
        let contact = m.mate.mate_type.kind().contact(&m.joint())?;
        // Mates of parts without a place are open already.
        let (a, b) = (placements.of(m.base)?, placements.of(m.incoming)?);
        Some(shown(door, resolved, m, contact, (a, b), pairs, tau).await)
    }))
    .await;
    let (mut verdict, mut cases) = (Verdict::Pass, 0);
    for ((m, fact), shown) in resolved.mates.iter().zip(facts).zip(found) {
        let Some(shown) = shown else { continue };
        cases += 1;
        verdict = verdict.and(shown.verdict);
        fact.contact = Some(shown.verdict);
        fact.contact_area_mm2 = shown.area_mm2.map(rounded);
        if let Some(diagnostic) = shown.diagnostic {
            results.findings.push(Finding {
                verdict: shown.verdict,
                check: "contact".to_owned(),
                parts: vec![m.mate.base.part.clone(), m.mate.incoming.part.clone()],
                mates: vec![m.mate.id.clone()],
                values: shown.values,
                axioms: Vec::new(),
                diagnostic,
            });
        }
    }
    results.check(
        "contact",
        verdict,
        cases,
        "where a mate promises contact: faces of both parts share area in its plane or about its axis, \
         press fits and threads overlap, gear flanks meet within the backlash",
    );
}

/// Asks whether a mate's contact is there.
async fn shown(
    door: Asker<'_>,
    resolved: &Resolved,
    m: &ResolvedMate,
    contact: Contact,
    (at_base, at_incoming): (Placement, Placement),
    pairs: &ByNames<'_>,
    tau: f64,
) -> Shown {
    let place = format!("mate '{}'", m.mate.id);
    let (Some(base), Some(incoming)) = (
        resolved.parts.get(m.base).map(|p| p.solid_at(&at_base)),
        resolved
            .parts
            .get(m.incoming)
            .map(|p| p.solid_at(&at_incoming)),
    ) else {
        let d = Diagnostic::error(Code::Internal, place, "a part is lost");
        return Shown::open(d);
    };
    let overlap = m.mate.mate_type.kind().overlap(&m.joint());
    let surface = match contact {
        Contact::Flanks(deg) => {
            return flanks(door, m, base, (incoming, at_incoming), deg, tau).await;
        }
        Contact::Cylinder if overlap.most_mm3 > tau => {
            return by_volume(m, between(m, pairs), overlap.most_mm3);
        }
        Contact::Cylinder => {
            let frame = at_base.frame(&m.base_port.frame);
            Where::Axis {
                point: frame.origin,
                direction: frame.z,
            }
        }
        Contact::Face => {
            let frame = at_incoming.frame(&m.incoming_port.frame);
            Where::Plane {
                point: frame.origin,
                normal: frame.z,
            }
        }
    };
    match door.contact(&base, &incoming, &surface).await {
        Ok(touch) => by_area(m, contact, touch),
        Err(f) => Shown::open(diagnostic(&f, &place)),
    }
}

/// Gear flanks meet when the incoming gear is turned by the window, either way.
async fn flanks(
    door: Asker<'_>,
    m: &ResolvedMate,
    base: PlacedSolid,
    (incoming, at): (PlacedSolid, Placement),
    deg: f64,
    tau: f64,
) -> Shown {
    let place = format!("mate '{}'", m.mate.id);
    let axis = at.frame(&m.incoming_port.frame);
    let mut values = Map::new();
    values.insert("window_deg".to_owned(), json!(rounded(deg)));
    let mut apart = Vec::new();
    for (way, turn) in [("left", deg), ("right", -deg)] {
        let turned = match Placement::rotation_about(axis.origin, axis.z, turn) {
            Ok(turn) => turn * at,
            Err(e) => {
                return Shown::open(Diagnostic::error(Code::Internal, place, e.to_string()));
            }
        };
        let turned = moved(&incoming, &turned);
        // A point of one wheel within the other settles it; else the kernel's boolean, whose word alone is not
        // taken for a contact where it warns.
        if matches!(door.enters(&base, &turned).await, Ok(true)) {
            continue;
        }
        let volume = match door.common_volume(&base, &turned, SAMPLES).await {
            Ok(v) if v.warnings.is_empty() => v.volume,
            Ok(v) => {
                let message = format!(
                    "whether the teeth meet is not known: turned {way} by {} degrees, the kernel finds {} mm3 \
                     in common, but warns: {}",
                    rounded(deg),
                    rounded(v.volume),
                    v.warnings.join("; ")
                );
                return Shown::open(Diagnostic::error(Code::Indeterminate, place, message));
            }
            Err(f) => return Shown::open(diagnostic(&f, &place)),
        };
        values.insert(format!("overlap_turned_{way}_mm3"), json!(rounded(volume)));
        // A volume that is no number shows nothing.
        if !matches!(volume.partial_cmp(&tau), Some(core::cmp::Ordering::Greater)) {
            apart.push(way);
        }
    }
    if apart.is_empty() {
        return Shown::held(None);
    }
    let d = Diagnostic::error(
        Code::ContactMissing,
        place,
        format!(
            "the teeth of '{}' and '{}' do not meet: turned {} by {} degrees, which is half the \
             backlash and 0.03 modules, no flank touches",
            m.mate.base,
            m.mate.incoming,
            apart.join(" and "),
            rounded(deg)
        ),
    )
    .hint(
        "see whether the gears lie beside each other along their axes, state the teeth's thinning in \
         their ports, or state the play as backlash_mm",
    );
    Shown::missing(d, values)
}

impl Shown {
    fn held(area_mm2: Option<f64>) -> Self {
        Self {
            verdict: Verdict::Pass,
            area_mm2,
            values: Map::new(),
            diagnostic: None,
        }
    }

    fn open(d: Diagnostic) -> Self {
        Self {
            verdict: Verdict::Indeterminate,
            area_mm2: None,
            values: Map::new(),
            diagnostic: Some(d),
        }
    }

    fn missing(d: Diagnostic, values: Map<String, Value>) -> Self {
        Self {
            verdict: Verdict::Fail,
            area_mm2: None,
            values,
            diagnostic: Some(d),
        }
    }
}

/// Pairs by the names of their parts, the lesser name first.
type ByNames<'a> = BTreeMap<(&'a str, &'a str), &'a PairFacts>;

fn by_names(pairs: &[PairFacts]) -> ByNames<'_> {
    let mut out = ByNames::new();
    for p in pairs {
        let (a, b) = (p.a.as_str(), p.b.as_str());
        out.entry((a.min(b), a.max(b))).or_insert(p);
    }
    out
}

/// What was found of the pair that a mate joins.
fn between<'a>(m: &ResolvedMate, pairs: &ByNames<'a>) -> Option<&'a PairFacts> {
    let (a, b) = (m.mate.base.part.as_str(), m.mate.incoming.part.as_str());
    pairs.get(&(a.min(b), a.max(b))).copied()
}

/// A press fit or a thread is where its parts overlap: at least half of what the mate says, since chamfers
/// take some of it. Parts whose boxes are apart are in no pair, and do not overlap.
fn by_volume(m: &ResolvedMate, pair: Option<&PairFacts>, wanted: f64) -> Shown {
    let place = format!("mate '{}'", m.mate.id);
    let volume = pair.map_or(Some(0.0), |p| p.common_volume_mm3);
    let Some(volume) = volume else {
        return Shown::open(Diagnostic::error(
            Code::Indeterminate,
            place,
            "whether they touch is not known: their common volume could not be computed",
        ));
    };
    if volume >= 0.5 * wanted {
        return Shown::held(None);
    }
    let d = Diagnostic::error(
        Code::ContactMissing,
        place,
        format!(
            "'{}' does not sit in '{}': they should overlap by {} mm3",
            m.mate.incoming,
            m.mate.base,
            rounded(wanted)
        ),
    )
    .found(json!({"common_volume_mm3": rounded(volume)}))
    .hint("see whether the two ports' lengths meet with the mate's offset");
    Shown::missing(d, Map::new())
}

fn by_area(m: &ResolvedMate, contact: Contact, touch: Touch) -> Shown {
    let place = format!("mate '{}'", m.mate.id);
    let surface = match contact {
        Contact::Face => "in the plane of the mate",
        _ => "on one cylinder about the mate's axis",
    };
    let mut values = Map::new();
    values.insert("contact_area_mm2".to_owned(), json!(rounded(touch.area)));
    values.insert("faces_of_base".to_owned(), json!(touch.faces_a));
    values.insert("faces_of_incoming".to_owned(), json!(touch.faces_b));
    if !touch.warnings.is_empty() {
        let message = format!(
            "the contact came out as {} mm2, but the kernel warns: {}",
            rounded(touch.area),
            touch.warnings.join("; ")
        );
        let mut shown = Shown::open(Diagnostic::error(Code::Indeterminate, place, message));
        shown.values = values;
        return shown;
    }
    // A touch that is no number is none.
    if touch.area > LEAST_MM2 {
        return Shown::held(Some(touch.area));
    }
    let why = match (touch.faces_a, touch.faces_b) {
        (0, _) => format!("'{}' has no face {surface}", m.mate.base.part),
        (_, 0) => format!("'{}' has no face {surface}", m.mate.incoming.part),
        _ => format!("their faces {surface} have no area in common"),
    };
    let d = Diagnostic::error(
        Code::ContactMissing,
        place,
        format!(
            "'{}' and '{}' do not touch: {why}",
            m.mate.base, m.mate.incoming
        ),
    )
    .expected(format!("a common area of more than {LEAST_MM2} mm2"))
    .hint(
        "change the mate's offsets so that the faces lie on each other, or, where a gap is meant, state it \
         (d_n_mm, d_mm) or give the parts play",
    );
    Shown::missing(d, values)
}
