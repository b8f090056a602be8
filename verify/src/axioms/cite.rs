//! Whether the axioms that a mate cites exist and apply to it.

use assemcad_axioms::query::{Query, applicable_to, applies, find};
use assemcad_axioms::{Applicability, Axiom, Class, axioms, knowledge};
use assemcad_model::diagnostic::{Code, Diagnostic, Severity};
use assemcad_model::mates::MateType;
use assemcad_model::name::nearest;
use assemcad_model::param::clip;
use assemcad_model::ports::PortType;
use assemcad_model::spec::Mate;
use assemcad_placing::{ResolvedMate, ResolvedPart};
use serde_json::{Map, Value, json};

/// How many axioms a diagnostic offers; the narrowest come first, and the tool finds the others.
const MOST_OFFERED: usize = 12;

/// What axioms are held against: as much as is known of a mate.
#[derive(Debug, Clone)]
pub struct Cited {
    mate_type: MateType,
    /// Types of the two ports and classes of the two parts; none where the mate is at fault itself.
    ends: Option<([PortType; 2], [Class; 2])>,
}

impl Cited {
    /// Of a mate that resolves.
    #[must_use]
    pub fn resolved(m: &ResolvedMate, parts: &[ResolvedPart]) -> Self {
        let class = |i: usize| parts.get(i).map(|p| Class::of_factory(&p.factory));
        let class = |i: usize| class(i).unwrap_or(Class::Custom);
        Self {
            mate_type: m.mate.mate_type,
            ends: Some((
                [m.base_port.port_type, m.incoming_port.port_type],
                [class(m.base), class(m.incoming)],
            )),
        }
    }

    /// Of a mate of which only the type is known.
    #[must_use]
    pub fn of_type(mate_type: MateType) -> Self {
        Self {
            mate_type,
            ends: None,
        }
    }

    /// The axioms that apply, the narrowest first.
    fn applicable(&self) -> Vec<&'static Axiom> {
        match &self.ends {
            Some(([b, c], classes)) => applicable_to(self.mate_type, *b, *c, classes),
            None => find(&Query {
                mate_type: Some(self.mate_type),
                ..Query::default()
            }),
        }
    }

    fn applies(&self, axiom: &Axiom) -> Applicability {
        match &self.ends {
            Some(([b, c], classes)) => applies(axiom, self.mate_type, *b, *c, classes),
            // What depends on something that is itself at fault is not guessed at.
            None => Applicability::Applies,
        }
    }

    /// Ids with titles, for `expected`.
    fn offered(&self) -> Value {
        let all = self.applicable();
        let offered = all.iter().take(MOST_OFFERED);
        let map: Map<String, Value> = offered
            .map(|a| (a.id.clone(), a.title.clone().into()))
            .collect();
        map.into()
    }

    fn look_up(&self, d: Diagnostic) -> Diagnostic {
        let mut ask = json!({"mate_type": self.mate_type});
        if let (Some((ports, classes)), Some(ask)) = (&self.ends, ask.as_object_mut()) {
            ask.insert("port_types".to_owned(), json!(ports));
            ask.insert("classes".to_owned(), json!(classes));
        }
        d.expected(self.offered()).next("find_axioms", ask)
    }

    /// What is wrong with the ids that a mate cites; `at` gives the place of one of them by its index,
    /// or of the list. `lacking` is how bad it is to cite none.
    pub fn check(
        &self,
        mate: &Mate,
        lacking: Severity,
        at: &dyn Fn(Option<usize>) -> String,
    ) -> Vec<Diagnostic> {
        if mate.axioms.is_empty() {
            let message = format!("the mate '{}' cites no axiom", clip(&mate.id));
            let d = Diagnostic {
                severity: lacking,
                ..Diagnostic::error(Code::AxiomMissing, at(None), message)
            };
            let hint = "say which engineering rule is the reason for this mate: axioms: [...]; find_axioms \
                        tells what each rule says";
            return vec![self.look_up(d.hint(hint))];
        }
        let each = mate.axioms.iter().enumerate();
        each.filter_map(|(i, id)| self.one(id, at(Some(i))))
            .collect()
    }

    fn one(&self, id: &str, place: String) -> Option<Diagnostic> {
        let Some(axiom) = knowledge::axiom(id) else {
            let message = format!("there is no axiom '{}'", clip(id));
            let d = Diagnostic::error(Code::AxiomUnknown, place, message).found(id);
            let ids = axioms().iter().map(|a| a.id.as_str());
            let d = match nearest(id, ids, 1).first() {
                Some(near) => d.hint(format!("did you mean '{near}'?")),
                None => d,
            };
            return Some(self.look_up(d));
        };
        let Applicability::Not { reason } = self.applies(axiom) else {
            return None;
        };
        let d = Diagnostic::error(Code::AxiomInapplicable, place, reason)
            .found(id)
            .hint("cite one of those that apply to this mate");
        Some(self.look_up(d))
    }
}
