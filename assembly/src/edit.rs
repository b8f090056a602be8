//! Changes to an assembly. Each is checked whole, then written to disk, then answered; a refused one
//! leaves the assembly as it was.

use assemcad_kernel::protocol::Built;
use assemcad_model::diagnostic::{Code, Diagnostic, Severity};
use assemcad_model::mates::Residual;
use assemcad_model::report::rounded;
use assemcad_model::spec::text::normalise;
use assemcad_model::spec::{Accepted, Assembly, Mate, Part, PartMotion};
use assemcad_placing::resolved::part_unknown;
use assemcad_placing::solids::{Box3, box_of, build};
use assemcad_placing::{Placements, Resolved, ResolvedMate, ResolvedPart, place};
use assemcad_verify::axioms::cite::Cited;
use serde_json::json;

use crate::resolve;
use crate::state::State;
use crate::{Faults, Workshop};
use assemcad_store::check_name;

/// Whether a change changed anything: a call made twice changes nothing the second time.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Change {
    /// It did.
    Made,
    /// All was already so.
    None,
}

/// What is stated beside parts and mates; none of what stays as it was.
#[derive(Debug, Default)]
pub struct Intent {
    /// How many independent motions are meant.
    pub intended_mobility: Option<u32>,
    /// Which they are.
    pub intended_motions: Option<Vec<PartMotion>>,
    /// What may lie loose.
    pub free: Option<Vec<PartMotion>>,
    /// Which rules are broken knowingly.
    pub accept: Option<Vec<Accepted>>,
}

/// A part as it was added.
#[derive(Debug)]
pub struct Added {
    /// Whether it is new.
    pub change: Change,
    /// Recipe and ports.
    pub part: ResolvedPart,
    /// What was measured of its solid.
    pub built: Built,
    /// The assembly now.
    pub state: State,
}

/// A mate as it was made.
#[derive(Debug)]
pub struct Mated {
    /// Whether it is new.
    pub change: Change,
    /// Ports and options.
    pub mate: ResolvedMate,
    /// How far it is from holding; none while one of its parts has no place.
    pub residual: Option<Residual>,
    /// The parts that got a place by it, each with a box around it in the world.
    pub placed: Vec<(String, Box3)>,
    /// The assembly now.
    pub state: State,
}

impl Workshop {
    /// Makes an assembly without parts.
    ///
    /// # Errors
    /// When the name is none, or another assembly has it.
    pub async fn new_assembly(
        &self,
        id: &str,
        description: &str,
    ) -> Result<(Change, State), Faults> {
        self.store.make_folder(id).map_err(one)?;
        let _lock = self.store.lock(id).await.map_err(one)?;
        let change = if self.store.exists(id) {
            let there = self.store.load(id).map_err(one)?;
            if there.description != description {
                return Err(one(Diagnostic::error(
                    Code::NameTaken,
                    "assembly",
                    format!("there is an assembly '{id}' with another description"),
                )
                .found(there.description)
                .hint("choose another name, or go on with the one there is")
                .next("get_assembly", json!({"assembly": id}))));
            }
            Change::None
        } else {
            self.store
                .save(&Assembly::new(id, description))
                .map_err(one)?;
            Change::Made
        };
        Ok((change, self.state(id).await?))
    }

    /// The state of an assembly.
    ///
    /// # Errors
    /// When it does not exist or no longer resolves.
    pub async fn state(&self, id: &str) -> Result<State, Faults> {
        let spec = self.store.load(id).map_err(one)?;
        let resolved = resolve::assembly(self, &spec).await?;
        State::of(&spec, &resolved).map_err(one)
    }

    /// Adds a part. Its solid is made first: a part that cannot be made is not added.
    ///
    /// # Errors
    /// Everything that is wrong with its name, factory, parameters or solid.
    pub async fn add_part(&self, assembly: &str, mut part: Part) -> Result<Added, Faults> {
        let _lock = self.store.lock(assembly).await.map_err(one)?;
        let mut spec = self.store.load(assembly).map_err(one)?;
        normalise(&mut part.params);
        if let Ok(factory) = self.registry.get(&part.factory) {
            part.factory = factory.name().to_owned();
        }
        let mut faults: Faults = check_name("part", &part.id).err().into_iter().collect();
        let change = match spec.part(&part.id) {
            Some(there) if *there == part => Change::None,
            Some(there) => {
                faults.push(taken("part", "part", assembly, &part.id).found(json!({
                    "factory": there.factory, "params": there.params,
                })));
                Change::None
            }
            None => Change::Made,
        };
        let resolved = match resolve::part(self, &part, "").await {
            Ok(resolved) => resolved,
            Err(more) => {
                faults.extend(more);
                return Err(faults);
            }
        };
        if !faults.is_empty() {
            return Err(faults);
        }
        let built = build(self.door.asker(), &resolved).await.map_err(one)?;
        if change == Change::Made {
            spec.parts.push(part);
        }
        let state = self.commit(&spec, change).await?;
        Ok(Added {
            change,
            part: resolved,
            built,
            state,
        })
    }

    /// Makes a mate. The first that joins a part without a place to one with a place places it; one
    /// between placed parts closes a loop, and must hold where they are.
    ///
    /// # Errors
    /// Everything that is wrong with its name, ports, type or options, or by how much it does not hold.
    pub async fn mate(&self, assembly: &str, mut mate: Mate) -> Result<Mated, Faults> {
        let _lock = self.store.lock(assembly).await.map_err(one)?;
        let mut spec = self.store.load(assembly).map_err(one)?;
        let before = resolve::assembly(self, &spec).await?;
        normalise(&mut mate.options);
        let mut faults: Faults = check_name("id", &mate.id).err().into_iter().collect();
        let change = match spec.mate(&mate.id) {
            Some(there) if *there == mate => Change::None,
            Some(there) => {
                faults.push(taken("mate", "id", assembly, &mate.id).found(json!({
                    "mate_type": there.mate_type, "base": there.base.to_string(),
                    "incoming": there.incoming.to_string(), "options": there.options,
                })));
                Change::None
            }
            None => Change::Made,
        };
        let at = |field: &str| argument(field);
        let resolved = match resolve::mate(&before.parts, assembly, &mate, &at) {
            Ok(resolved) => resolved,
            Err(more) => {
                faults.extend(more);
                return Err(faults);
            }
        };
        let cited = Cited::resolved(&resolved, &before.parts);
        let (wrong, warnings): (Faults, Faults) = cited
            .check(&mate, Severity::Warning, &|_| "axioms".to_owned())
            .into_iter()
            .partition(|d| d.severity == Severity::Error);
        faults.extend(wrong);
        if !faults.is_empty() {
            return Err(faults);
        }
        if change == Change::Made {
            spec.mates.push(mate);
        }
        let after = resolve::assembly(self, &spec).await?;
        let now = place::assembly(&after).map_err(one)?;
        let residual = now.residual(&resolved).map_err(one)?;
        if let Some(r) = residual.filter(|r| change == Change::Made && !r.holds()) {
            return Err(one(does_not_hold(&resolved, &r)));
        }
        let mut state = self.commit_resolved(&spec, &after, change)?;
        state.warnings.extend(warnings);
        let placed = self.newly_placed(&before, &after, &now).await?;
        Ok(Mated {
            change,
            mate: resolved,
            residual,
            placed,
            state,
        })
    }

    /// The parts that have a place now and had none before, with their boxes in the world.
    async fn newly_placed(
        &self,
        before: &Resolved,
        after: &Resolved,
        now: &Placements,
    ) -> Result<Vec<(String, Box3)>, Faults> {
        let then = place::assembly(before).map_err(one)?;
        let mut boxes = Vec::new();
        for (i, part) in after.parts.iter().enumerate() {
            if let (None, Some(at)) = (then.of(i), now.of(i)) {
                // The mate is accepted and on disk: a lost worker must not make it look refused.
                if let Ok(built) = build(self.door.asker(), part).await {
                    boxes.push((part.id.clone(), box_of(&built, &at)));
                }
            }
        }
        Ok(boxes)
    }

    /// Removes a mate.
    ///
    /// # Errors
    /// When there is none of this name.
    pub async fn remove_mate(&self, assembly: &str, id: &str) -> Result<State, Faults> {
        let _lock = self.store.lock(assembly).await.map_err(one)?;
        let mut spec = self.store.load(assembly).map_err(one)?;
        if spec.mate(id).is_none() {
            let names: Vec<&str> = spec.mates.iter().map(|m| m.id.as_str()).collect();
            return Err(one(Diagnostic::error(
                Code::MateUnknown,
                "name",
                format!("there is no mate '{}'", assemcad_model::param::clip(id)),
            )
            .found(id)
            .expected(json!(names))));
        }
        spec.mates.retain(|m| m.id != id);
        self.commit(&spec, Change::Made).await
    }

    /// States what is meant beside parts and mates. What is left out stays as it was.
    ///
    /// # Errors
    /// When it names parts that are not there, or contradicts itself.
    pub async fn state_intent(
        &self,
        assembly: &str,
        intent: Intent,
    ) -> Result<(Change, State), Faults> {
        let _lock = self.store.lock(assembly).await.map_err(one)?;
        let mut spec = self.store.load(assembly).map_err(one)?;
        let before = spec.clone();
        if intent.intended_mobility.is_some() {
            spec.intended_mobility = intent.intended_mobility;
        }
        if let Some(motions) = intent.intended_motions {
            spec.intended_motions = motions;
        }
        if let Some(free) = intent.free {
            spec.free = free;
        }
        if let Some(accept) = intent.accept {
            spec.accept = accept;
        }
        let mut faults = spec.stated_faults();
        faults.extend(assemcad_verify::axioms::accept::faults(&spec));
        if !faults.is_empty() {
            return Err(faults);
        }
        let change = if spec == before {
            Change::None
        } else {
            Change::Made
        };
        Ok((change, self.commit(&spec, change).await?))
    }

    /// Removes a part that no mate uses.
    ///
    /// # Errors
    /// When there is none of this name, or mates use it.
    pub async fn remove_part(&self, assembly: &str, id: &str) -> Result<State, Faults> {
        let _lock = self.store.lock(assembly).await.map_err(one)?;
        let mut spec = self.store.load(assembly).map_err(one)?;
        let resolved = resolve::assembly(self, &spec).await?;
        if spec.part(id).is_none() {
            return Err(one(part_unknown(&resolved.parts, id, "name")));
        }
        let users: Vec<&str> = spec.mates_of(id).map(|m| m.id.as_str()).collect();
        if let Some(first) = users.first() {
            return Err(one(Diagnostic::error(
                Code::InUse,
                "name",
                format!("part '{id}' is joined by {} mate(s)", users.len()),
            )
            .found(json!(users))
            .hint("remove these mates first")
            .next(
                "remove",
                json!({"assembly": assembly, "kind": "mate", "name": first}),
            )));
        }
        spec.parts.retain(|p| p.id != id);
        if spec.root.as_deref() == Some(id) {
            spec.root = None;
        }
        spec.intended_motions.retain(|m| m.part != id);
        spec.free.retain(|m| m.part != id);
        for a in &mut spec.accept {
            a.parts.retain(|p| p != id);
        }
        spec.accept.retain(|a| !a.parts.is_empty());
        self.commit(&spec, Change::Made).await
    }

    /// Checks the whole specification, writes it, and gives the state it is in.
    async fn commit(&self, spec: &Assembly, change: Change) -> Result<State, Faults> {
        let resolved = resolve::assembly(self, spec).await?;
        self.commit_resolved(spec, &resolved, change)
    }

    /// Writes a specification that was checked, and gives the state it is in.
    fn commit_resolved(
        &self,
        spec: &Assembly,
        resolved: &Resolved,
        change: Change,
    ) -> Result<State, Faults> {
        let mut state = State::of(spec, resolved).map_err(one)?;
        if change == Change::Made {
            state.warnings = self.store.lost_by_writing(&spec.id);
            self.store.save(spec).map_err(one)?;
        }
        Ok(state)
    }
}

/// The argument of the `mate` tool that holds a field of a mate: its options are arguments of their own.
fn argument(field: &str) -> String {
    match field {
        "options" => "arguments".to_owned(),
        other => other.to_owned(),
    }
}

fn one(d: Diagnostic) -> Faults {
    vec![d]
}

fn taken(kind: &str, place: &str, assembly: &str, name: &str) -> Diagnostic {
    Diagnostic::error(
        Code::NameTaken,
        place,
        format!("there is another {kind} '{name}'"),
    )
    .hint(format!(
        "choose another name, or remove the {kind} that has it"
    ))
    .next(
        "remove",
        json!({"assembly": assembly, "kind": kind, "name": name}),
    )
}

fn does_not_hold(m: &ResolvedMate, r: &Residual) -> Diagnostic {
    Diagnostic::error(
        Code::MateResidual,
        "mate",
        format!(
            "both parts have a place already, and there '{}' and '{}' are {} mm and {} degrees from this mate",
            m.mate.base, m.mate.incoming, rounded(r.distance_mm), rounded(r.angle_deg),
        ),
    )
    .found(json!({"distance_mm": rounded(r.distance_mm), "angle_deg": rounded(r.angle_deg)}))
    .expected(json!({
        "distance_mm": Residual::MAX_DISTANCE_MM, "angle_deg": Residual::MAX_ANGLE_DEG,
    }))
    .hint(if r.angle_deg > 179.999 && r.distance_mm <= Residual::MAX_DISTANCE_MM {
        "the axes look the wrong way round: give this mate the other 'direction', or the one that \
         placed the part if that is what is turned over"
    } else {
        "change the options of the mates that placed these parts, or remove one of them"
    })
}
