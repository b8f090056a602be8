//! What the checks of the axioms read, from a placed and measured assembly.

use std::collections::{BTreeMap, BTreeSet};

use assemcad_axioms::facts::{
    Facts, Geometry, JointMotion, MateContact, MateFacts, Measured, Mobility, PairOverlap,
    PartFacts, Redundant,
};
use assemcad_axioms::indexed::Indexed;
use assemcad_axioms::reasons::reasons;
use assemcad_factories::Registry;
use assemcad_model::freedom::Freedom;
use assemcad_model::report::{self, Overlapping, Verdict};
use assemcad_model::spec::{Assembly, Mate, Part};
use assemcad_placing::linkage::freedom_of;
use assemcad_placing::{Assembled, Placements, Resolved};
use serde_json::{Map, Value};

use crate::checks::interference::limit_mm3;

/// What the other checks measured.
pub(crate) struct Measurements<'a> {
    pub(crate) parts: &'a [report::PartFacts],
    pub(crate) mates: &'a [report::MateFacts],
    pub(crate) pairs: &'a [report::PairFacts],
    pub(crate) tau_mm3: f64,
    /// Which motions the mates leave, where that could be told.
    pub(crate) freedom: Option<&'a Freedom>,
    /// How many independent motions the machine has, where that could be told.
    pub(crate) motions: Option<usize>,
}

/// The facts of an assembly. Materials are in no specification and stay unknown: the checks say what they
/// take for granted.
pub(super) fn facts(
    registry: &Registry,
    spec: &Assembly,
    assembled: &Assembled<'_>,
    measured: &Measurements<'_>,
) -> Indexed {
    let (resolved, placements) = (assembled.resolved, assembled.placements);
    let mut written: BTreeMap<&str, &Part> = BTreeMap::new();
    for p in &spec.parts {
        written.entry(&p.id).or_insert(p);
    }
    let mut defaults: BTreeMap<&str, Map<String, Value>> = BTreeMap::new();
    for p in &resolved.parts {
        let of = || defaults_of(registry, &p.factory);
        defaults.entry(&p.factory).or_insert_with(of);
    }
    let parts = resolved.parts.iter().enumerate().map(|(i, p)| PartFacts {
        id: p.id.clone(),
        factory: p.factory.clone(),
        class: None,
        params: params(
            written.get(p.id.as_str()).copied(),
            defaults.get(p.factory.as_str()),
        ),
        elastic: written.get(p.id.as_str()).is_some_and(|w| w.elastic),
        ports: p.ports().to_vec(),
        placement: placements.of(i),
        material: None,
        geometry: measured.parts.get(i).and_then(geometry),
    });
    let mates = resolved.mates.iter().map(|m| MateFacts {
        id: m.mate.id.clone(),
        mate_type: m.mate.mate_type,
        base: m.mate.base.clone(),
        incoming: m.mate.incoming.clone(),
        options: m.mate.options.clone(),
        axioms: m.mate.axioms.clone(),
        reason_stated: reason_stated(spec, &m.mate),
    });
    let mut facts = Indexed::new(Facts {
        root: spec.root.clone(),
        parts: parts.collect(),
        mates: mates.collect(),
        intended_mobility: spec.motions_meant(),
        meant_to_move: spec
            .intended_motions
            .iter()
            .map(|m| m.part.clone())
            .collect(),
        mobility: measured
            .freedom
            .and_then(|f| mobility(f, measured.motions?)),
        measured: Measured {
            overlaps: Some(overlaps(measured)),
            contacts: Some(contacts(measured)),
            ..Measured::default()
        },
    });
    let left = unexplained(&facts, resolved, placements);
    if let Some(mobility) = facts.mobility_mut() {
        mobility.unexplained = left;
    }
    facts
}

/// What is still held twice when the mates are left out for which a pattern of joints gives the reason; none
/// where there are no such mates, or nothing is held twice.
fn unexplained(
    facts: &Indexed,
    resolved: &Resolved,
    placements: &Placements,
) -> Option<Vec<Redundant>> {
    let mobility = facts.mobility.as_ref()?;
    let explained: BTreeSet<&str> = reasons(facts).iter().map(|r| r.mate).collect();
    if mobility.redundant.is_empty() || explained.is_empty() {
        return None;
    }
    let mut rest = resolved.clone();
    rest.mates
        .retain(|m| !explained.contains(&m.mate.id.as_str()));
    Some(redundant(&freedom_of(&rest, placements)?))
}

fn redundant(freedom: &Freedom) -> Vec<Redundant> {
    let each = freedom.redundant.iter().flat_map(|loop_| {
        let each = loop_.mates.iter().zip(&loop_.repeated);
        each.map(|(mate, repeated)| Redundant {
            mate: mate.clone(),
            count: count(*repeated),
        })
    });
    each.collect()
}

fn count(n: usize) -> u32 {
    u32::try_from(n).unwrap_or(u32::MAX)
}

/// The motions of the machine, idle spins left out; none where their number could not be told.
fn mobility(freedom: &Freedom, motions: usize) -> Option<Mobility> {
    let joints = freedom.joints.iter().map(|j| JointMotion {
        mate: j.mate.clone(),
        turns: count(j.turns),
        slides: count(j.slides),
        screws: count(j.screws),
    });
    Some(Mobility {
        freedom: count(motions),
        redundant: redundant(freedom),
        unexplained: None,
        joints: joints.collect(),
    })
}

/// The parameters of a part, with its factory's defaults filled in.
fn params(part: Option<&Part>, defaults: Option<&Map<String, Value>>) -> Map<String, Value> {
    let mut params = part.map(|p| p.params.clone()).unwrap_or_default();
    for (name, value) in defaults.into_iter().flatten() {
        if !params.contains_key(name) {
            params.insert(name.clone(), value.clone());
        }
    }
    params
}

/// The defaults of a factory's parameters; none of one that is not there.
fn defaults_of(registry: &Registry, factory: &str) -> Map<String, Value> {
    let factory = registry.get(factory);
    let params = factory.iter().flat_map(|f| f.params());
    params
        .map(|p| (p.name.clone(), p.default_value()))
        .collect()
}

fn geometry(p: &report::PartFacts) -> Option<Geometry> {
    Some(Geometry {
        volume_mm3: p.volume_mm3?,
        centre_mm: p.centre_mm?,
        box_mm: p.box_mm?,
    })
}

/// The volume that counts as meant is the one that the check of interference allows: what the mates mean
/// and the threshold of the verification.
fn overlaps(measured: &Measurements<'_>) -> Vec<PairOverlap> {
    let overlap = |p: &report::PairFacts| PairOverlap {
        a: p.a.clone(),
        b: p.b.clone(),
        common_mm3: match p.class {
            Overlapping::Unknown => None,
            _ => p.common_volume_mm3,
        },
        allowed_mm3: limit_mm3(p.allowed_mm3.unwrap_or_default(), measured.tau_mm3),
    };
    measured.pairs.iter().map(overlap).collect()
}

fn contacts(measured: &Measurements<'_>) -> Vec<MateContact> {
    let contact = |m: &report::MateFacts| {
        Some(MateContact {
            mate: m.mate.clone(),
            touches: match m.contact? {
                Verdict::Pass => Some(true),
                Verdict::Fail => Some(false),
                Verdict::Indeterminate => None,
            },
        })
    };
    measured.mates.iter().filter_map(contact).collect()
}

/// Whether it is accepted of a mate's parts that it takes freedoms again; a note says nothing.
fn reason_stated(spec: &Assembly, mate: &Mate) -> bool {
    let both = [&mate.base.part, &mate.incoming.part];
    let mut accepted = spec.accept.iter();
    accepted.any(|a| a.axiom == "C-05" && both.iter().all(|p| a.parts.contains(*p)))
}
