//! S-01: an order of assembly exists.

use super::Check;
use crate::apart::{groups, locked};
use crate::facts::{Way, Ways};
use crate::indexed::Indexed;
use crate::ruling::{About, Ruling, Status};
use assemcad_model::ports::PortType;

/// Taken apart along straight ways, nothing is left together.
pub struct AssemblyOrder;

impl Check for AssemblyOrder {
    fn id(&self) -> &'static str {
        "assembly_order"
    }

    fn axiom(&self) -> &'static str {
        "S-01"
    }

    fn run(&self, facts: &Indexed) -> Vec<Ruling> {
        // What has no place is another check's, and a part alone needs no order.
        let placed: Vec<String> = facts
            .parts
            .iter()
            .filter(|p| p.placement.is_some())
            .map(|p| p.id.clone())
            .collect();
        if placed.len() < 2 {
            return Vec::new();
        }
        let Some(ways) = &facts.measured.ways else {
            let message = "what is in whose way was not measured";
            return vec![Ruling::new(
                self.axiom(),
                Status::Indeterminate,
                About::assembly(),
                message,
            )];
        };
        // What springs gives way: its way in is no matter of rigid parts.
        let springs = |id: &String| facts.part(id).is_some_and(|p| p.elastic);
        let rigid = |way: &Way| Way {
            axis: way.axis,
            stops: way
                .stops
                .iter()
                .filter(|s| !springs(&s.part) && !springs(&s.by))
                .cloned()
                .collect(),
        };
        let ways = &Ways {
            axes: ways.axes.iter().map(rigid).collect(),
            ..ways.clone()
        };
        let left = groups(&placed, &ways.axes);
        let stuck: Vec<&Vec<String>> = left.iter().filter(|g| g.len() > 1).collect();
        let mut out: Vec<Ruling> = stuck.iter().map(|g| self.stuck(facts, ways, g)).collect();
        for unseen in &ways.open {
            let message = format!("the way of '{}' is not known: {}", unseen.part, unseen.why);
            let about = About::parts([&unseen.part]);
            out.push(Ruling::new(
                self.axiom(),
                Status::Indeterminate,
                about,
                message,
            ));
        }
        if out.is_empty() {
            let message = format!(
                "the {} parts come apart one by one along straight ways, and go together the other way round",
                placed.len()
            );
            let v = Ruling::held(self.axiom(), true, About::assembly(), message)
                .value("parts", placed.len() as f64)
                .value("axes", ways.axes.len() as f64);
            out.push(v.assuming(sampled(ways)));
        }
        out
    }
}

impl AssemblyOrder {
    /// Two parts that hold each other are locked in; of more parts together it is not certain, since ways with
    /// turns and corners are not looked for, and snap hooks give way.
    fn stuck(&self, facts: &Indexed, ways: &Ways, group: &[String]) -> Ruling {
        let names = group
            .iter()
            .map(|p| format!("'{p}'"))
            .collect::<Vec<_>>()
            .join(", ");
        let ways_n = 2 * ways.axes.len();
        let gives = |id: &str| {
            let part = facts.part(id);
            part.is_some_and(|p| p.ports.iter().any(|x| x.port_type == PortType::SnapFit))
        };
        let pair = locked(group, &ways.axes).filter(|(a, b)| {
            !gives(a) && !gives(b) && (within(facts, a, b) || within(facts, b, a))
        });
        let (status, about, message) = match pair {
            Some((a, b)) => (
                Status::Fail,
                About::parts([a, b]),
                format!(
                    "'{a}' and '{b}' hold each other: along none of {ways_n} straight ways do they come apart"
                ),
            ),
            None => (
                Status::Indeterminate,
                About::parts(group),
                format!(
                    "along none of {ways_n} straight ways do some of {names} come away from the others; whether \
                     they do with turns, corners or springing is not known"
                ),
            ),
        };
        Ruling::new(self.axiom(), status, about, message)
            .value("directions", ways_n as f64)
            .assuming(sampled(ways))
    }
}

/// Whether the box of one part lies wholly within that of another: only what is enclosed is shown to have no way in
/// by straight ways that are all closed.
fn within(facts: &Indexed, inner: &str, outer: &str) -> bool {
    let of = |id: &str| {
        facts
            .part(id)
            .and_then(|p| p.geometry.as_ref())
            .map(|g| g.box_mm)
    };
    let (Some([low, high]), Some([from, to])) = (of(inner), of(outer)) else {
        return false;
    };
    low.iter().zip(from).all(|(a, b)| *a > b) && high.iter().zip(to).all(|(a, b)| *a < b)
}

fn sampled(ways: &Ways) -> String {
    format!(
        "parts are rigid and come in straight, on threads and helices along their axes; seen on {0} by {0} rays \
         over what two parts have in common in outline, not proven between them; pairs that overlap \
         more than their mates mean are left out",
        ways.rays_a_side
    )
}
