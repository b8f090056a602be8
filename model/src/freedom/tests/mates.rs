//! Parts joined by mates.

use serde_json::{Map, Value, json};

use super::numbers;
use crate::frame::{Frame, Placement};
use crate::freedom::{Body, Freedom, System, analyse, link_of, spin_axis};
use crate::mates::{Joint, MateType};
use crate::ports::PortType::{
    BoltSeat, Bore, ClearanceHole, FlatFace, GearMesh, Hole, PressFit, Shaft, ThreadExternal,
    ThreadInternal,
};
use crate::ports::{Port, PortType};

/// A port at a point of its part, looking along an axis.
fn port(port_type: PortType, at: [f64; 3], z: [f64; 3], params: &[(&str, f64)]) -> Port {
    let x = if z[0].abs() > 0.5 {
        [0.0, 1.0, 0.0]
    } else {
        [1.0, 0.0, 0.0]
    };
    Port {
        name: "p".to_owned(),
        port_type,
        frame: Frame::new(at, z, x).unwrap(),
        params: params.iter().map(|(n, v)| ((*n).to_owned(), *v)).collect(),
    }
}

/// Parts placed by their first mates as an assembly's parts are, the first part standing still.
#[derive(Default)]
struct Bench {
    system: System,
    at: Vec<Placement>,
    mates: usize,
}

impl Bench {
    fn new() -> Self {
        let mut bench = Self::default();
        bench.part("base", Placement::IDENTITY);
        bench.system.root = Some(0);
        bench
    }

    fn part(&mut self, name: &str, at: Placement) -> usize {
        self.system.bodies.push(Body {
            name: name.to_owned(),
            at: at.origin().into(),
            spin: None,
        });
        self.at.push(at);
        self.at.len() - 1
    }

    /// Mates two parts; one that has no place yet is brought in.
    fn mate(
        &mut self,
        t: MateType,
        (b, base): (usize, &Port),
        (name, incoming): (&str, &Port),
        options: Value,
    ) -> usize {
        let empty = Map::new();
        let kind = t.kind();
        let options = kind
            .check_options(options.as_object().unwrap_or(&empty), "")
            .unwrap();
        let known = self.system.bodies.iter().position(|p| p.name == name);
        let c = known.unwrap_or_else(|| {
            let at = kind
                .place_incoming(&self.at[b], base, incoming, &options)
                .unwrap();
            self.part(name, at)
        });
        let residual = kind.residual(&self.at[b], base, &self.at[c], incoming, &options);
        assert!(residual.unwrap().holds(), "{t} {name}");
        let joint = Joint {
            base,
            incoming,
            options: &options,
        };
        let id = format!("m{}", self.mates);
        self.mates += 1;
        let link = link_of(&id, t, &joint, (b, &self.at[b]), (c, &self.at[c]));
        self.system.links.push(link.unwrap());
        c
    }

    fn spins(&mut self, part: usize, ports: &[Port]) {
        let at = self.at[part];
        self.system.bodies[part].spin = spin_axis(ports).map(|a| super::Axis {
            point: at.point(a.point),
            direction: at.direction(a.direction),
        });
    }

    fn solve(&self) -> Freedom {
        analyse(&self.system)
    }
}

const UP: [f64; 3] = [0.0, 0.0, 1.0];
const O: [f64; 3] = [0.0; 3];

#[test]
fn a_bolt_through_two_plates_with_clearance_spins_and_slides_until_it_is_seated() {
    let hole = port(ClearanceHole, O, UP, &[("diameter", 6.6), ("depth", 10.0)]);
    let face = |at: f64, z: f64| port(FlatFace, [30.0, 0.0, at], [0.0, 0.0, z], &[]);
    let bolt = port(
        ThreadExternal,
        O,
        [0.0, 0.0, -1.0],
        &[("diameter", 6.0), ("pitch", 1.0), ("length", 40.0)],
    );
    let head = port(
        BoltSeat,
        O,
        [0.0, 0.0, -1.0],
        &[("inner_diameter", 6.0), ("outer_diameter", 10.0)],
    );
    let mut b = Bench::new();
    b.mate(
        MateType::FaceToFace,
        (0, &face(0.0, 1.0)),
        ("plate", &face(-10.0, -1.0)),
        json!({}),
    );
    // The holes are in line, so the plate turns about them; the bolt turns and slides in them.
    let plate = 1;
    let lower = port(
        ClearanceHole,
        [0.0, 0.0, -10.0],
        UP,
        &[("diameter", 6.6), ("depth", 10.0)],
    );
    // The plate lies turned over on the base: its hole, where the base has its own, looks against the base's.
    let at = b.at[plate].inverse().point(O);
    let through = port(
        ClearanceHole,
        at,
        [0.0, 0.0, -b.at[plate].direction(UP)[2]],
        &[("diameter", 6.6), ("depth", 10.0)],
    );
    b.mate(
        MateType::Coaxial,
        (0, &hole),
        ("plate", &through),
        json!({"direction": "opposed"}),
    );
    let bolt_at = b.mate(MateType::Coaxial, (0, &lower), ("bolt", &bolt), json!({}));
    // Plane and axis: both hold the plate's two tilts.
    let f = b.solve();
    assert_eq!(numbers(&f), (3, 2, 3));
    b.spins(bolt_at, &[bolt.clone(), head.clone()]);
    let f = b.solve();
    assert_eq!((numbers(&f), f.idle_spins), ((3, 2, 3), 1));
    let names: Vec<&str> = f.motions.iter().map(|m| m.name.as_str()).collect();
    assert_eq!(
        names,
        [
            "'bolt' spins idly about z through [0, 0, 0]",
            "'plate' turns about z through [0, 0, 0]",
            "'bolt' slides along z",
        ]
    );
}

#[test]
fn a_press_fitted_bearing_stands_and_its_shaft_turns() {
    let seat = port(Hole, O, UP, &[("diameter", 20.0), ("depth", 10.0)]);
    let ring = port(
        PressFit,
        [0.0, 0.0, 5.0],
        [0.0, 0.0, 1.0],
        &[("diameter", 20.0), ("length", 10.0)],
    );
    let bore = port(
        Bore,
        [0.0, 0.0, 10.0],
        UP,
        &[("diameter", 8.0), ("depth", 10.0)],
    );
    let shaft = port(Shaft, O, UP, &[("diameter", 8.0), ("length", 60.0)]);
    let mut b = Bench::new();
    let bearing = b.mate(
        MateType::PressFit,
        (0, &seat),
        ("bearing", &ring),
        json!({"d_mm": -5.0, "direction": "same"}),
    );
    b.spins(bearing, &[ring.clone(), bore.clone()]);
    let f = b.solve();
    assert_eq!((numbers(&f), f.idle_spins), ((0, 0, 0), 0));
    let at = b.mate(
        MateType::Coaxial,
        (bearing, &bore),
        ("shaft", &shaft),
        json!({"direction": "same"}),
    );
    b.spins(at, core::slice::from_ref(&shaft));
    let f = b.solve();
    // A shaft's turning is what it is for: not idle.
    assert_eq!((numbers(&f), f.idle_spins), ((2, 0, 2), 0));
    assert_eq!(f.motions[0].name, "'shaft' turns about z through [0, 0, 0]");
    assert_eq!(f.motions[1].name, "'shaft' slides along z");
}

#[test]
fn a_plate_that_is_fixed_twice_names_both() {
    let face = |z: f64| {
        port(
            FlatFace,
            [0.0, 0.0, z],
            [0.0, 0.0, z.signum()],
            &[("extent_x", 10.0), ("extent_y", 10.0)],
        )
    };
    let mut b = Bench::new();
    for _ in 0..2 {
        b.mate(
            MateType::SnapToFace,
            (0, &face(1.0)),
            ("plate", &face(-1.0)),
            json!({}),
        );
    }
    let f = b.solve();
    assert_eq!(numbers(&f), (0, 6, 0));
    assert_eq!(f.redundant.len(), 1);
    assert_eq!(f.redundant[0].dispensable, ["m0", "m1"]);
}

/// Two bolts screwed into holes of one plate through another, and the plates on each other: the threads hold the
/// bolts, the bolts hold nothing sideways but their holes' axes.
#[test]
fn a_second_bolt_repeats_what_the_first_holds() {
    let thread = |x: f64| {
        port(
            ThreadInternal,
            [x, 0.0, 0.0],
            UP,
            &[
                ("diameter", 6.0),
                ("pitch", 1.0),
                ("hand", 1.0),
                ("depth", 12.0),
            ],
        )
    };
    let screw = port(
        ThreadExternal,
        [0.0, 0.0, -30.0],
        [0.0, 0.0, -1.0],
        &[
            ("diameter", 6.0),
            ("pitch", 1.0),
            ("hand", 1.0),
            ("length", 30.0),
        ],
    );
    let hole = |x: f64| {
        port(
            ClearanceHole,
            [x, 0.0, 0.0],
            [0.0, 0.0, -1.0],
            &[("diameter", 6.6), ("depth", 10.0)],
        )
    };
    let shank = port(
        ThreadExternal,
        [0.0, 0.0, -20.0],
        UP,
        &[("diameter", 6.0), ("pitch", 1.0), ("length", 30.0)],
    );
    let mut b = Bench::new();
    for (x, name) in [(0.0, "left"), (40.0, "right")] {
        let bolt = b.mate(
            MateType::ThreadEngage,
            (0, &thread(x)),
            (name, &screw),
            json!({"d_t_mm": 10.0}),
        );
        b.mate(
            MateType::Coaxial,
            (bolt, &shank),
            ("plate", &hole(x)),
            json!({}),
        );
        let f = b.solve();
        // One bolt: the plate turns and slides. Two: it slides, their parallel axes being held in tilt twice and
        // in distance once: 2 + 1 redundant.
        let wanted = if x == 0.0 { (2, 0, 2) } else { (1, 3, 1) };
        assert_eq!(numbers(&f), wanted);
    }
}

#[test]
fn gears_on_their_shafts_turn_together() {
    let gear = |teeth: f64, at: [f64; 3]| {
        port(
            GearMesh,
            at,
            UP,
            &[
                ("module", 1.0),
                ("teeth", teeth),
                ("internal", 0.0),
                ("pressure_angle_deg", 20.0),
                ("helix_angle_deg", 0.0),
                ("profile_shift", 0.0),
                ("width", 10.0),
                ("thinning", 0.0),
            ],
        )
    };
    let bore = port(Bore, O, UP, &[("diameter", 8.0), ("depth", 10.0)]);
    let pin = |x: f64| {
        port(
            Shaft,
            [x, 0.0, 0.0],
            UP,
            &[("diameter", 8.0), ("length", 20.0)],
        )
    };
    let on = json!({"direction": "same"});
    let mut b = Bench::new();
    let first = b.mate(
        MateType::Coaxial,
        (0, &pin(0.0)),
        ("pinion", &bore),
        on.clone(),
    );
    b.mate(
        MateType::GearMesh,
        (first, &gear(20.0, O)),
        ("wheel", &gear(40.0, O)),
        json!({}),
    );
    b.mate(MateType::Coaxial, (0, &pin(30.0)), ("wheel", &bore), on);
    let f = b.solve();
    // One turn of both, and each slides along its axis: the teeth are straight.
    assert_eq!(numbers(&f), (3, 0, 3));
    assert!(
        f.motions.iter().any(|m| m.name
            == "'pinion' turns about z through [0, 0, 0]; 'wheel' turns about z through [30, 0, 0], -0.5 times"),
        "{f:#?}"
    );
}
