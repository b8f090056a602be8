//! The gears: ports as documented, and what is refused.

use assemcad_model::ports::PortType;
use serde_json::json;

use super::kit::{NZ, X, Z, port, refused, sound};

#[test]
fn the_ports_of_the_spur_gear() {
    let ports = sound("gear.spur", &json!({})).ports;
    assert_eq!(ports.len(), 5);
    assert!(ports.iter().all(|p| p.frame.x == X));
    let mesh = port(&ports, "mesh_point");
    assert_eq!(mesh.port_type, PortType::GearMesh);
    assert_eq!((mesh.frame.origin, mesh.frame.z), ([0.0, 0.0, 7.5], Z));
    let wanted = [
        ("helix_angle_deg", 0.0),
        ("internal", 0.0),
        ("module", 2.0),
        ("pressure_angle_deg", 20.0),
        ("profile_shift", 0.0),
        ("teeth", 20.0),
        ("thinning", 0.0),
        ("width", 15.0),
    ];
    let found: Vec<(&str, f64)> = mesh.params.iter().map(|(k, v)| (k.as_str(), *v)).collect();
    assert_eq!(found, wanted);
    for (name, z, direction) in [("bore", 15.0, Z), ("bore_back", 0.0, NZ)] {
        let bore = port(&ports, name);
        assert_eq!(bore.port_type, PortType::Bore);
        assert_eq!(
            (bore.frame.origin, bore.frame.z),
            ([0.0, 0.0, z], direction)
        );
        assert_eq!(
            (bore.params["diameter"], bore.params["depth"]),
            (12.0, 15.0)
        );
    }
    for (name, z, direction) in [("face_top", 15.0, Z), ("face_bottom", 0.0, NZ)] {
        let face = port(&ports, name);
        assert_eq!(face.port_type, PortType::FlatFace);
        // Halfway between the bore (6) and the root circle (20 - 2.5).
        assert_eq!(
            (face.frame.origin, face.frame.z),
            ([11.75, 0.0, z], direction)
        );
        let e = face.params["extent_x"];
        assert_eq!(face.params["extent_y"], e);
        assert!(((11.75 + e / 2.0) * (11.75 + e / 2.0) + e * e / 4.0 - 17.5 * 17.5).abs() < 1e-6);
        assert!(11.75 - e / 2.0 > 6.0 && e > 8.0);
    }
}

#[test]
fn what_is_no_gear_is_refused_with_its_reason() {
    for (params, word) in [
        (json!({"teeth": 16}), "at least 17 teeth"),
        (json!({"teeth": 12, "profile_shift": 0.29}), "undercut"),
        (json!({"teeth": 28, "pressure_angle_deg": 14.5}), "undercut"),
        (
            json!({"teeth": 9, "profile_shift": 0.9, "bore_d": 5}),
            "pointed",
        ),
        (json!({"bore_d": 33.1}), "bore_d is at most 33.0"),
        (json!({"backlash_mm": 0.7}), "backlash_mm"),
    ] {
        let faults = refused("gear.spur", &params);
        assert!(
            faults.iter().any(|f| f.message.contains(word)),
            "{params}: {faults:?}"
        );
    }
    for params in [
        json!({"teeth": 17}),
        json!({"teeth": 12, "profile_shift": 0.3}),
        json!({"teeth": 400, "module": 0.2}),
        json!({"teeth": 9, "pressure_angle_deg": 30, "bore_d": 8}),
        json!({"bore_d": 33}),
        json!({"backlash_mm": 0.6}),
    ] {
        sound("gear.spur", &params);
    }
}
