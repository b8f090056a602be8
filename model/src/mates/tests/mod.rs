//! What holds for all mate types.

mod gears;

use super::{ALL, Joint, MateKind, MateType, Options, Residual, compatibility_table};
use crate::frame::{Frame, Placement};
use crate::ports::{self, Port, PortType};
use proptest::prelude::*;
use serde_json::{Value, json};

/// A port in the origin; its parameters need not be complete.
pub(super) fn port(port_type: PortType, params: &[(&str, f64)]) -> Port {
    Port {
        name: "p".to_owned(),
        port_type,
        frame: Frame::WORLD,
        params: params.iter().map(|(n, v)| ((*n).to_owned(), *v)).collect(),
    }
}

/// What a mate type says of two joined ports.
pub(super) fn joined<T>(
    name: &str,
    base: &Port,
    incoming: &Port,
    given: Value,
    ask: impl Fn(&MateKind, &Joint<'_>) -> T,
) -> T {
    let kind = ALL.iter().find(|k| k.name == name).unwrap();
    let options = options(kind.mate_type, given);
    ask(
        kind,
        &Joint {
            base,
            incoming,
            options: &options,
        },
    )
}

fn placed(port_type: PortType, frame: Frame) -> Port {
    Port {
        frame,
        ..port(port_type, &[])
    }
}

fn options(t: MateType, given: Value) -> Options {
    t.kind()
        .check_options(given.as_object().unwrap(), "options")
        .unwrap()
}

#[test]
fn every_file_is_listed_once_and_in_order() {
    let files = std::fs::read_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/src/mates")).unwrap();
    let mut files: Vec<String> = files
        .map(|f| f.unwrap().file_name().into_string().unwrap())
        .filter(|f| {
            !["effect.rs", "mod.rs", "serving.rs", "shared.rs", "tests"].contains(&f.as_str())
        })
        .map(|f| f.trim_end_matches(".rs").to_owned())
        .collect();
    files.sort();
    let listed: Vec<&str> = ALL.iter().map(|k| k.name).collect();
    assert_eq!(files, listed);
    for kind in ALL {
        assert_eq!(serde_json::to_value(kind.mate_type).unwrap(), kind.name);
        assert!(std::ptr::eq(kind.mate_type.kind(), kind));
        assert!(kind.pairs.is_sorted());
    }
}

#[test]
fn a_block_on_a_plate() {
    // Plate top at z = 15, block bottom at z = 0 looking down. u = 10, v = -20, no spin.
    let base = placed(
        PortType::FlatFace,
        Frame::new([0.0, 0.0, 15.0], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]).unwrap(),
    );
    let incoming = placed(
        PortType::FlatFace,
        Frame::new([0.0; 3], [0.0, 0.0, -1.0], [1.0, 0.0, 0.0]).unwrap(),
    );
    let kind = MateType::FaceToFace.kind();
    let o = options(
        MateType::FaceToFace,
        json!({"u_mm": 10, "v_mm": -20, "d_n_mm": 0.5}),
    );
    let t = kind
        .place_incoming(&Placement::IDENTITY, &base, &incoming, &o)
        .unwrap();
    // The block stands upright, its bottom half a millimetre above the plate, exactly.
    assert_eq!(t, Placement::translation(10.0, -20.0, 15.5));
    let spun = options(MateType::FaceToFace, json!({"alpha_deg": 90}));
    let t = kind
        .place_incoming(&Placement::IDENTITY, &base, &incoming, &spun)
        .unwrap();
    // alpha turns right-handed about the incoming face's outward normal (here -Z).
    assert_eq!(
        t,
        Placement::translation(0.0, 0.0, 15.0) * Placement::rotation_z(-90.0)
    );
}

#[test]
fn a_shaft_in_a_bore() {
    // Bore along -Y from its mouth at y = 20, z = 40; shaft along Z.
    let bore = placed(
        PortType::Bore,
        Frame::new([0.0, 20.0, 40.0], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0]).unwrap(),
    );
    let shaft = placed(PortType::Shaft, Frame::WORLD);
    let kind = MateType::Coaxial.kind();
    for (given, end) in [
        (json!({"d_mm": -20}), [0.0, -1.0, 40.0]),
        (json!({"d_mm": -20, "direction": "same"}), [0.0, 1.0, 40.0]),
    ] {
        let o = options(MateType::Coaxial, given);
        let t = kind
            .place_incoming(&Placement::IDENTITY, &bore, &shaft, &o)
            .unwrap();
        assert_eq!(t.point([0.0, 0.0, 0.0]), [0.0, 0.0, 40.0]);
        assert_eq!(t.point([0.0, 0.0, 1.0]), end);
    }
}

fn any_frame() -> impl Strategy<Value = Frame> {
    let n = prop::array::uniform3(-1.0..1.0f64);
    (prop::array::uniform3(-500.0..500.0f64), n.clone(), n).prop_filter_map(
        "degenerate",
        |(o, z, s)| {
            let (z, s) = (nalgebra::Vector3::from(z), nalgebra::Vector3::from(s));
            let x = z.cross(&s);
            (x.norm() > 0.1).then(|| Frame::new(o, z.into(), x.into()).ok())?
        },
    )
}

/// Ports, options and a shift in the base port's frame whose size across what the mate constrains is `off`.
fn case(t: MateType, n: [f64; 4], same: bool, off: f64) -> (Port, Port, Value, [f64; 3]) {
    use PortType as P;
    let [a, b, c, alpha] = n;
    let direction = if same { "same" } else { "opposed" };
    let all = [2.0 / 3.0 * off, -2.0 / 3.0 * off, off / 3.0];
    match t {
        MateType::FaceToFace => (
            port(P::FlatFace, &[]),
            port(P::FlatFace, &[]),
            json!({"u_mm": a, "v_mm": b, "d_n_mm": c, "alpha_deg": alpha}),
            [3.0, -4.0, off],
        ),
        MateType::Coaxial => (
            port(P::Bore, &[]),
            port(P::Shaft, &[]),
            json!({"d_mm": c, "alpha_deg": alpha, "direction": direction}),
            [0.6 * off, 0.8 * off, 7.0],
        ),
        MateType::CoaxialFace => (
            port(P::CboreSeat, &[]),
            port(P::BoltSeat, &[]),
            json!({"d_mm": c, "alpha_deg": alpha}),
            all,
        ),
        MateType::PressFit => (
            port(P::Bore, &[]),
            port(P::Shaft, &[]),
            json!({"d_mm": c, "alpha_deg": alpha, "direction": direction}),
            all,
        ),
        MateType::ThreadEngage => (
            port(P::ThreadInternal, &[]),
            port(P::ThreadExternal, &[]),
            json!({"d_t_mm": c.abs(), "through_mm": a.abs(), "alpha_deg": alpha}),
            all,
        ),
        MateType::SnapToFace => (
            port(P::FlatFace, &[("extent_x", 30.0), ("extent_y", 20.0)]),
            port(P::FlatFace, &[]),
            json!({"u": a.abs() / 50.0, "v": b.abs() / 50.0, "d_n_mm": c, "alpha_deg": alpha}),
            all,
        ),
        MateType::GearMesh => {
            let gear = |teeth: f64, helix: f64, internal: bool| {
                let internal = f64::from(u8::from(internal));
                port(
                    P::GearMesh,
                    &[
                        ("module", 2.0),
                        ("teeth", teeth),
                        ("pressure_angle_deg", 20.0),
                        ("helix_angle_deg", helix),
                        ("width", 10.0),
                        ("internal", internal),
                    ],
                )
            };
            // `same` stands for a ring as base.
            let teeth = libm::floor(17.0 + a.abs());
            let (base, helix) = if same {
                (gear(teeth + 50.0, 20.0, true), 20.0)
            } else {
                (gear(33.0, 20.0, false), -20.0)
            };
            let (s, c) = crate::angle::sin_cos_deg(alpha);
            (
                base,
                gear(teeth, helix, false),
                json!({"angle_deg": alpha, "backlash_mm": b.abs() / 100.0}),
                [off * c, off * s, 0.0],
            )
        }
    }
}

proptest! {
    #[test]
    fn a_placed_mate_holds_and_a_disturbed_one_tells_by_how_much(
        world in any_frame(), fb in any_frame(), fc in any_frame(),
        n in prop::array::uniform3(-50.0..50.0f64),
        alpha in -360.0..360.0f64, same in any::<bool>(), off in 0.01..10.0f64,
        tilt in 0.01..30.0f64, turn in -2.0..2.0f64,
    ) {
        for kind in ALL {
            let (mut base, mut incoming, given, shift) =
                case(kind.mate_type, [n[0], n[1], n[2], alpha], same, off);
            base.frame = fb;
            incoming.frame = fc;
            let o = options(kind.mate_type, given);
            let at = world.placement().unwrap();
            let t = kind.place_incoming(&at, &base, &incoming, &o).unwrap();
            prop_assert!(t.orthonormality_error() < 1e-12);
            let r = kind.residual(&at, &base, &t, &incoming, &o).unwrap();
            prop_assert!(r.holds(), "{} {r:?}", kind.name);
            // Placing the base from the incoming part leads back.
            let back = kind.place_base(&t, &base, &incoming, &o).unwrap();
            let p = [1.0, 2.0, 3.0];
            for (u, v) in back.point(p).iter().zip(at.point(p)) {
                prop_assert!((u - v).abs() < 1e-9);
            }
            // A shift across what the mate constrains is found with its size.
            let lb = at * base.frame.placement().unwrap();
            let shift = Placement::translation(shift[0], shift[1], shift[2]);
            let moved = lb * shift * lb.inverse() * t;
            let r = kind.residual(&at, &base, &moved, &incoming, &o).unwrap();
            prop_assert!((r.distance_mm - off).abs() < 1e-8 && r.angle_deg < 1e-6, "{} {r:?}", kind.name);
            // So is a tilt.
            let lc = t * incoming.frame.placement().unwrap();
            let tilted = lc * Placement::rotation_x(tilt) * lc.inverse() * t;
            let r = kind.residual(&at, &base, &tilted, &incoming, &o).unwrap();
            prop_assert!((r.angle_deg - tilt).abs() < 1e-8, "{} {r:?}", kind.name);
            // What is free stays free: along every twist the residual stays away, to first order.
            let j = Joint { base: &base, incoming: &incoming, options: &o };
            for twist in kind.freedom(&j).twists {
                let e = 1e-5;
                let [wx, wy, wz, vx, vy, vz] = twist.0.map(|v| v * e);
                prop_assert!(wx == 0.0 && wy == 0.0);
                let step = Placement::translation(vx, vy, vz)
                    * Placement::rotation_z(wz * 180.0 / core::f64::consts::PI);
                let moved = lb * step * lb.inverse() * t;
                let r = kind.residual(&at, &base, &moved, &incoming, &o).unwrap();
                prop_assert!(r.distance_mm < 1e-6 && r.angle_deg < 1e-6, "{} {r:?}", kind.name);
            }
            if kind.mate_type == MateType::GearMesh {
                // A turn of one gear is found; turns of both by the ratio are free.
                let spin = |l: &Placement, deg: f64| *l * Placement::rotation_z(deg) * l.inverse();
                let off = spin(&lc, turn) * t;
                let r = kind.residual(&at, &base, &off, &incoming, &o).unwrap();
                prop_assert!((r.angle_deg - turn.abs()).abs() < 1e-8, "{r:?}");
                let ratio = kind.freedom(&j).coupling.unwrap().ratio;
                let (b, c) = (spin(&lb, 40.0 * turn) * at, spin(&lc, ratio * 40.0 * turn) * t);
                let r = kind.residual(&b, &base, &c, &incoming, &o).unwrap();
                prop_assert!(r.holds(), "{r:?}");
            }
        }
    }
}

#[test]
fn the_compatibility_relation_is_the_golden_one() {
    golden("compatibility.txt", &compatibility_table());
    let joins = |m: MateType, a, b| m.kind().joins(a, b);
    assert!(joins(MateType::Coaxial, PortType::Bore, PortType::Bore));
    for other in ports::ALL {
        let gear = PortType::GearMesh;
        let own = other.port_type == gear;
        assert_eq!(joins(MateType::GearMesh, gear, other.port_type), own);
        assert_eq!(joins(MateType::GearMesh, other.port_type, gear), own);
    }
}

/// Each mate on oblique frames, in two poses.
#[test]
fn the_transforms_are_the_golden_ones() {
    let oblique = |point: [f64; 3], axis: [f64; 3], deg: f64| {
        Placement::rotation_about(point, axis, deg)
            .unwrap()
            .frame(&Frame {
                origin: [3.0, 5.0, 7.0],
                ..Frame::WORLD
            })
    };
    let mut text = String::new();
    for kind in ALL {
        for same in [false, true] {
            let (mut base, mut incoming, given, _) =
                case(kind.mate_type, [10.0, -20.0, 4.0, 25.0], same, 0.0);
            base.frame = oblique([1.0, 2.0, 3.0], [1.0, -2.0, 0.5], 37.0);
            incoming.frame = oblique([-4.0, 0.0, 1.0], [0.3, 1.0, 2.0], -64.0);
            let at = oblique([0.0; 3], [1.0, 1.0, 1.0], 50.0)
                .placement()
                .unwrap();
            let o = options(kind.mate_type, given.clone());
            let t = kind.place_incoming(&at, &base, &incoming, &o).unwrap();
            text.push_str(&format!("{} {given}\n", kind.name));
            for row in crate::frame::Rows::from(t).0 {
                let row = row.map(|v| format!("{v:16.10}"));
                text.push_str(&format!("{}\n", row.join(" ")));
            }
        }
    }
    golden("mate_transforms.txt", &text);
}

fn golden(name: &str, found: &str) {
    let path = format!("{}/tests/golden/{name}", env!("CARGO_MANIFEST_DIR"));
    if std::env::var_os("ASSEMCAD_ACCEPT").is_some() {
        std::fs::write(&path, found).unwrap();
    }
    let wanted = std::fs::read_to_string(&path).unwrap_or_default();
    assert!(
        found == wanted,
        "{name} changed; if that is meant: ASSEMCAD_ACCEPT=1 cargo test -p assemcad-model golden\n{found}"
    );
}

#[test]
fn no_number_is_no_hold() {
    assert!(
        !Residual {
            distance_mm: f64::NAN,
            angle_deg: 0.0
        }
        .holds()
    );
}
