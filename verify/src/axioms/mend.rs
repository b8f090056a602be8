//! What would mend a broken axiom, in plain words, and the call to begin with where one is known.

use assemcad_axioms::Axiom;
use assemcad_axioms::ruling::Ruling;
use assemcad_model::diagnostic::Diagnostic;
use assemcad_model::spec::Assembly;
use serde_json::json;

/// What is changed to mend it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum By {
    /// Parameters of the part.
    Params,
    /// Options of the mate: it is removed and made again.
    Options,
    /// Parts or mates that are lacking.
    More,
}

/// A diagnostic with advice, and the call to begin with.
pub(super) fn mended(axiom: &Axiom, told: &Ruling, spec: &Assembly, d: Diagnostic) -> Diagnostic {
    let Some((by, hint)) = remedy(&axiom.id) else {
        return d.next("find_axioms", json!({"id": axiom.id}));
    };
    let d = d.hint(hint);
    let factory = told.about.parts.first().and_then(|p| spec.part(p));
    match (by, told.about.mates.first(), factory) {
        (By::Options, Some(mate), _) => d.next(
            "remove",
            json!({"assembly": spec.id, "kind": "mate", "name": mate}),
        ),
        (By::Params, _, Some(part)) => d.next("describe_factory", json!({"factory": part.factory})),
        _ => d.next("find_axioms", json!({"id": axiom.id})),
    }
}

fn remedy(id: &str) -> Option<(By, &'static str)> {
    use By::{More, Options, Params};
    Some(match id {
        "B-01" => (
            More,
            "mate the bearing's inner ring with a shaft and its outer ring with a bore",
        ),
        "B-02" => (
            Options,
            "give one of the two rings a coaxial mate instead of a press fit",
        ),
        "B-03" => (
            Params,
            "give the shaft a collar as long as the gap between two bearings that are pressed into their housing, \
             or press a ring on it",
        ),
        "B-04" => (
            More,
            "locate one bearing on both rings, by press fits or faces, and leave the other free",
        ),
        "C-03" => (
            Params,
            "make the shaft thicker than its hole, or mate them coaxial",
        ),
        "C-04" => (
            Options,
            "make the mate again with u and v nearer to 0.5, or make the face larger",
        ),
        "F-02" => (
            More,
            "name a part of structure, such as a plate or a housing, as 'root', or make it the first part",
        ),
        "G-01" => (
            Options,
            "let the gear_mesh mate place one of the gears, or move the bores that carry their shafts",
        ),
        "G-02" | "G-03" | "G-05" | "G-06" | "G-07" => (
            Params,
            "change the teeth, module, pressure angle, helix or profile shift of the gears",
        ),
        "G-08" => (
            Options,
            "thin the teeth of the gears (parameter backlash_mm of gear.spur, thinning of a port), about 0.05 times the module; backlash_mm of the mate widens the centre distance, which fixed axles do not give",
        ),
        "G-09" => (
            Params,
            "choose teeth so that sun and ring together divide by the number of planets",
        ),
        "H-02" => (Params, "make the pin longer"),
        "H-03" => (
            More,
            "press the pin into one leaf, or give it a stop at either end",
        ),
        "K-04" => (More, "take one gear out of the ring, or put another in"),
        "N-02" => (Params, "make the part larger or the bore smaller"),
        "N-03" | "N-04" => (
            Params,
            "move the holes, make them smaller, or make the part larger",
        ),
        "N-05" => (Params, "make the ground larger, or move the parts over it"),
        "N-06" => (
            More,
            "join the part on a second wall that stands at an angle to the first",
        ),
        "N-07" => (Params, "give both parts the same pattern of holes"),
        "P-01" => (
            More,
            "carry the shaft at a second place along its axis, by another bearing or bore",
        ),
        "P-02" => (
            Options,
            "press the hub on its shaft (press_fit), or add a key",
        ),
        "P-03" => (Params, "make the hub longer: one shaft diameter at least"),
        "S-01" => (
            More,
            "divide the part that encloses the other one, or open it on one side, and join its pieces with mates",
        ),
        "S-02" => (
            Options,
            "turn the fastener round, move what stands before it, or give that part a hole for the tool",
        ),
        "S-03" => (
            More,
            "put the ground first in the list of parts, and mates in the order in which parts are brought in",
        ),
        "T-01" => (
            More,
            "mate the bolt's seat with what it clamps (coaxial_face) and its thread with a nut or a threaded hole (thread_engage)",
        ),
        "T-03" => (
            Params,
            "take a longer bolt, a deeper thread or a smaller diameter",
        ),
        "T-04" => (Params, "take a shorter bolt or a deeper hole"),
        "T-05" => (Params, "take a longer bolt, a lower nut or fewer washers"),
        "T-06" => (
            Params,
            "give the hole the clearance of ISO 273 for its bolt",
        ),
        "T-07" => (More, "put a washer between the head or nut and the hole"),
        "T-08" => (
            Params,
            "give the shaft a flat or a dimple where the set screw comes in",
        ),
        "T-09" => (More, "add a second fastener or a locating feature"),
        "T-10" => (Params, "take a wider head, a washer or a smaller hole"),
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::remedy;
    use assemcad_axioms::{axioms, checks};

    #[test]
    fn every_checked_axiom_has_advice_or_stands_here() {
        let (checked, rest): (Vec<_>, Vec<_>) =
            axioms().iter().partition(|a| checks::of(a).is_some());
        assert!(rest.iter().all(|a| remedy(&a.id).is_none()));
        let without = checked.iter().filter(|a| remedy(&a.id).is_none());
        let without: Vec<&str> = without.map(|a| a.id.as_str()).collect();
        // What other checks find and advise on, and what only says what there is.
        assert_eq!(
            without,
            [
                "C-01", "C-02", "C-05", "F-01", "F-03", "F-04", "F-05", "G-04", "H-01", "H-04",
                "H-05", "K-01", "K-02", "K-03", "K-05", "N-01", "T-02", "T-12",
            ]
        );
    }
}
