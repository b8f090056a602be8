//! P-01: a rotating part is carried.

use assemcad_model::mates::MateType;

use super::Check;
use crate::asked::turns;
use crate::class::Class;
use crate::facts::{MateFacts, PartFacts, Side};
use crate::geometry::NEAR_MM;
use crate::indexed::Indexed;
use crate::joints::{about_part, is_cylinder, is_hole, reach_along};
use crate::ruling::{Ruling, Status};

/// A shaft has two places along its axis that carry it, or one that takes moments.
pub struct ShaftSupport;

/// A plain bore this many diameters long takes moments. Ours: the play of a running fit then lets the shaft
/// tilt by little.
const LONG: f64 = 1.5;

/// A place that carries a shaft.
struct Place<'a> {
    mate: &'a MateFacts,
    hole: Side<'a>,
    /// Its middle along the axis, where it is placed.
    at: Option<f64>,
}

impl Check for ShaftSupport {
    fn id(&self) -> &'static str {
        "shaft_support"
    }

    fn axiom(&self) -> &'static str {
        "P-01"
    }

    fn run(&self, facts: &Indexed) -> Vec<Ruling> {
        let rotating = facts.parts.iter().filter(|p| turns(facts, p));
        rotating
            .map(|shaft| carried(self.axiom(), facts, shaft))
            .collect()
    }
}

/// Whether a part carries a shaft; gears, couplings and what lies on it are carried by it.
fn carries(class: Class) -> bool {
    class.is_structure() || matches!(class, Class::BallBearing | Class::Custom)
}

fn places<'a>(facts: &'a Indexed, shaft: &PartFacts) -> Vec<Place<'a>> {
    let mut out: Vec<Place<'a>> = Vec::new();
    let mut along: Option<Side<'a>> = None;
    for mate in facts.mates_of(&shaft.id) {
        let Some((own, other)) = facts.seen_from(&shaft.id, mate) else {
            continue;
        };
        let fits = is_cylinder(own.port.port_type) && is_hole(other.port.port_type);
        if !fits || !carries(other.part.class()) {
            continue;
        }
        let along = *along.get_or_insert(own);
        let at = reach_along(&along, &other).map(|(low, high)| (low + high) / 2.0);
        out.push(Place {
            mate,
            hole: other,
            at,
        });
    }
    out
}

fn carried(axiom: &str, facts: &Indexed, shaft: &PartFacts) -> Ruling {
    let places = places(facts, shaft);
    let about = about_part(shaft, places.iter().map(|p| p.mate));
    let custom = places.iter().any(|p| p.hole.part.class() == Class::Custom);
    let verdict = |status, message: String| {
        let v = Ruling::new(axiom, status, about.clone(), message);
        if custom {
            v.assuming("a part of a user's factory with the shaft in its bore carries the shaft")
        } else {
            v
        }
    };
    let stiff = places.iter().find(|p| {
        let plain = p.hole.part.class() != Class::BallBearing;
        let pressed = p.mate.mate_type == MateType::PressFit;
        plain && (pressed || p.hole.port.value("depth") >= LONG * p.hole.port.value("diameter"))
    });
    let placed: Option<Vec<f64>> = places.iter().map(|p| p.at).collect();
    let Some(at) = placed else {
        let message = format!("the places that carry '{}' are not placed", shaft.id);
        return verdict(Status::Indeterminate, message);
    };
    let low = at.iter().copied().fold(f64::INFINITY, f64::min);
    let high = at.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    if places.len() > 1 && high - low > NEAR_MM {
        let message = format!("'{}' is carried at {} places", shaft.id, places.len());
        return verdict(Status::Pass, message).value("span_mm", high - low);
    }
    match (stiff, places.len()) {
        (Some(p), _) => {
            let message = format!(
                "'{}' is carried by '{}', which takes moments",
                shaft.id, p.hole.part.id
            );
            verdict(Status::Pass, message).assuming(
                "a press fit takes moments, and so does a plain bore of 1.5 diameters in length",
            )
        }
        (None, 0) => verdict(Status::Fail, format!("nothing carries '{}'", shaft.id)),
        (None, _) => {
            let message = format!(
                "'{}' is carried at one short place, about which it tilts",
                shaft.id
            );
            verdict(Status::Fail, message)
        }
    }
}
