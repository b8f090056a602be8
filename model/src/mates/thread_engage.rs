//! `thread_engage`: a screw's thread in a threaded hole. Leaves nothing free, or with `free` the screw
//! motion of the pitch.

use core::f64::consts::PI;

use super::{
    Condition, Contact, Freedom, Joint, MateKind, MateType, Overlap, Residual, Twist, at_most,
    degrees, distance_mm, off_axis_mm, opposed_residual_deg, over, within,
};
use crate::frame::Placement;
use crate::param::{ParamKind, ParamSpec};
use crate::ports::Port;
use crate::ports::PortType::{ThreadExternal, ThreadInternal};

pub(super) static KIND: MateKind = MateKind {
    mate_type: MateType::ThreadEngage,
    name: "thread_engage",
    doc: "Screws a thread d_t deep into a threaded hole, z axes opposed; through lets the screw's end \
          stand out of a nut's far side; free leaves the screw motion (a spindle drive).",
    pairs: &[
        (ThreadExternal, ThreadInternal),
        (ThreadInternal, ThreadExternal),
    ],
    options: || {
        vec![
            within(
                "d_t_mm",
                "length of the thread that is engaged; must be stated",
                "mm",
                0.0,
                1e5,
            ),
            within(
                "through_mm",
                "how far the screw's end stands out of the hole's far side",
                "mm",
                0.0,
                1e5,
            ),
            degrees("alpha_deg", "turn about the incoming port's z"),
            ParamSpec {
                name: "free".to_owned(),
                doc: "whether the screw motion is left free, as in a spindle drive".to_owned(),
                kind: ParamKind::Flag { default: false },
            },
        ]
    },
    relative,
    residual,
    conditions,
    freedom,
    contact: |_| Some(Contact::Cylinder),
    overlap,
    radial_play: |_| None,
};

fn hole_and_screw<'a>(j: &Joint<'a>) -> (&'a Port, &'a Port) {
    match j.base.port_type {
        ThreadInternal => (j.base, j.incoming),
        _ => (j.incoming, j.base),
    }
}

/// Where the incoming origin is on the base port's z. Seen from the hole's mouth, the screw's end is that
/// deep inside; seen from the screw's end, the hole's mouth is as far behind it: the same number.
fn height(j: &Joint<'_>) -> f64 {
    -(j.number("d_t_mm") + j.number("through_mm"))
}

fn relative(j: &Joint<'_>) -> Placement {
    Placement::translation(0.0, 0.0, height(j))
        * Placement::rotation_x(180.0)
        * Placement::rotation_z(j.number("alpha_deg"))
}

/// The turn is not constrained: the threads are cosmetic and have no phase. A free screw's depth is
/// not either: it goes with the turn.
fn residual(j: &Joint<'_>, actual: &Placement) -> Residual {
    Residual {
        distance_mm: if j.flag("free") {
            off_axis_mm(actual)
        } else {
            distance_mm(actual, height(j))
        },
        angle_deg: opposed_residual_deg(actual),
    }
}

/// Right-handed rotation about an axis advances a right-hand screw along that axis by a pitch per turn.
/// It is the same for the screw in the hole and for the hole on the screw.
fn freedom(j: &Joint<'_>) -> Freedom {
    if !j.flag("free") {
        return Freedom::none();
    }
    let advance = j.base.value("hand") * j.base.value("pitch") / (2.0 * PI);
    Freedom::of(&[Twist([0.0, 0.0, 1.0, 0.0, 0.0, advance])])
}

fn conditions(j: &Joint<'_>) -> Vec<Condition> {
    let (hole, screw) = hole_and_screw(j);
    let mut out = Vec::new();
    for (name, what) in [
        ("diameter", "mm nominal diameter"),
        ("pitch", "mm pitch"),
        ("hand", "as hand"),
    ] {
        let (h, s) = (hole.value(name), screw.value(name));
        // Written so that an unknown value fits nothing; the tolerance takes up decimal fractions only.
        if !at_most((h - s).abs(), 1e-9) {
            out.push(Condition {
                message: format!(
                    "the threads differ: '{}' has {s} {what}, '{}' has {h}",
                    screw.name, hole.name
                ),
                found: s,
                expected: format!("{name} {h}"),
            });
        }
    }
    let (engaged, through) = (j.number("d_t_mm"), j.number("through_mm"));
    let (depth, length) = (hole.value("depth"), screw.value("length"));
    let mut bad = |message: String, found: f64, expected: String| {
        out.push(Condition {
            message,
            found,
            expected,
        });
    };
    if !over(engaged, 0.0) {
        let message = "the engagement d_t_mm is not stated".to_owned();
        bad(
            message,
            engaged,
            format!("d_t_mm over 0, up to {} mm", depth.min(length)),
        );
    }
    if !at_most(engaged, depth) {
        let message = format!("'{}' has only {depth} mm of thread", hole.name);
        bad(message, engaged, format!("d_t_mm of at most {depth}"));
    }
    if !at_most(engaged + through, length) {
        let message = format!("'{}' has only {length} mm of thread", screw.name);
        bad(
            message,
            engaged + through,
            format!("d_t_mm and through_mm of together at most {length}"),
        );
    }
    if through > 0.0 && !at_most((engaged - depth).abs(), 1e-9) {
        let message =
            "a screw that stands out of the far side is engaged over the whole hole".to_owned();
        bad(
            message,
            engaged,
            format!("d_t_mm = {depth} where through_mm is over 0"),
        );
    }
    out
}

/// The threads are cosmetic: the two plain cylinders overlap in the ring between their modelled diameters,
/// over the engagement. A chamfer may take a little of it.
fn overlap(j: &Joint<'_>) -> Overlap {
    let (hole, screw) = hole_and_screw(j);
    let (h, s) = (
        hole.value("modelled_diameter"),
        screw.value("modelled_diameter"),
    );
    Overlap {
        least_mm3: 0.0,
        most_mm3: (PI / 4.0 * (s - h) * (s + h) * j.number("d_t_mm")).max(0.0),
        why: "the ring between the modelled diameters of the threads".to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use crate::mates::tests::{joined, port};
    use crate::ports::Port;
    use crate::ports::PortType::{ThreadExternal, ThreadInternal};
    use core::f64::consts::PI;
    use serde_json::{Value, json};

    fn nut(pitch: f64, hand: f64) -> Port {
        let p = [
            ("diameter", 8.0),
            ("pitch", pitch),
            ("hand", hand),
            ("depth", 6.5),
            ("modelled_diameter", 6.8),
        ];
        port(ThreadInternal, &p)
    }

    fn bolt() -> Port {
        let p = [
            ("diameter", 8.0),
            ("pitch", 1.25),
            ("hand", 1.0),
            ("length", 22.0),
            ("modelled_diameter", 8.0),
        ];
        port(ThreadExternal, &p)
    }

    fn faults(nut: &Port, options: Value) -> usize {
        let a = joined("thread_engage", nut, &bolt(), options.clone(), |k, j| {
            k.conditions(j).len()
        });
        let b = joined("thread_engage", &bolt(), nut, options, |k, j| {
            k.conditions(j).len()
        });
        assert_eq!(a, b);
        a
    }

    #[test]
    fn threads_that_differ_or_do_not_reach_are_refused() {
        let own = nut(1.25, 1.0);
        assert_eq!(faults(&own, json!({"d_t_mm": 6.5})), 0);
        assert_eq!(faults(&own, json!({})), 1);
        assert_eq!(faults(&own, json!({"d_t_mm": 7})), 1);
        assert_eq!(faults(&own, json!({"d_t_mm": 6.5, "through_mm": 3})), 0);
        assert_eq!(faults(&own, json!({"d_t_mm": 6.5, "through_mm": 16})), 1);
        assert_eq!(faults(&own, json!({"d_t_mm": 6, "through_mm": 3})), 1);
        assert_eq!(faults(&nut(1.0, 1.0), json!({"d_t_mm": 6})), 1);
        assert_eq!(faults(&nut(1.25, -1.0), json!({"d_t_mm": 6})), 1);
    }

    #[test]
    fn overlap_and_screw_motion() {
        let o = json!({"d_t_mm": 6, "free": true});
        let (overlap, free) = joined("thread_engage", &nut(1.25, 1.0), &bolt(), o, |k, j| {
            (k.overlap(j), k.freedom(j))
        });
        // pi/4 (8^2 - 6.8^2) 6 = pi/4 * 17.76 * 6.
        assert!((overlap.most_mm3 - PI * 26.64).abs() < 1e-9, "{overlap:?}");
        assert_eq!(free.twists.len(), 1);
        // One turn (2 pi) advances by the pitch.
        assert!((free.twists[0].0[5] * 2.0 * PI - 1.25).abs() < 1e-12);
    }
}
