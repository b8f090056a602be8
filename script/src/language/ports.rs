//! What can be said of a port before its geometry is made: its name, its type, its parameters.

use std::collections::BTreeMap;

use assemcad_model::frame::Frame;
use assemcad_model::language::Method;
use assemcad_model::name;
use assemcad_model::param::clip;
use assemcad_model::ports::{ALL, Port, PortKind, PortType};
use serde_json::Value as Json;

use super::convert::json_of;
use crate::fault::Fault;
use crate::involute::Toothing;

/// Checks the arguments of a method that declares a port, and adds what the front end knows itself.
pub(crate) fn complete(method: &Method, args: &mut BTreeMap<String, Json>) -> Result<(), Fault> {
    let Some(kind) = kind_of(method, args)? else {
        return Ok(());
    };
    for word in ["name", "back", "center"] {
        if let Some(Json::String(name)) = args.get(word)
            && !name::is_valid(name)
        {
            return Err(Fault::new(format!("'{}' cannot name a port", clip(name)))
                .hint(format!("names are {}", name::RULE)));
        }
    }
    match method.name {
        "Workplane.port" => whole_port(kind, args),
        "Workplane.gear_mesh_port" => {
            ranges(kind, args)?;
            let outline = toothing(args)?.outline().map_err(Fault::new)?;
            args.insert("outline".to_owned(), json_of(&outline)?);
            Ok(())
        }
        _ => ranges(kind, args),
    }
}

/// The type of the port that a method declares.
fn kind_of(
    method: &Method,
    args: &BTreeMap<String, Json>,
) -> Result<Option<&'static PortKind>, Fault> {
    let port_type = match method.name {
        "Workplane.bore_port" => PortType::Bore,
        "Workplane.shaft_port" => PortType::Shaft,
        "Workplane.hole_with_port" if args.contains_key("bolt_diameter") => PortType::ClearanceHole,
        "Workplane.hole_with_port" | "Workplane.csk_hole_with_port" => PortType::Hole,
        // Its port's diameter and depth are those of the counterbore; the hole's are checked here.
        "Workplane.cbore_hole_with_port" => PortType::Hole,
        "Workplane.tapped_hole_with_port" => PortType::ThreadInternal,
        "Workplane.face_port" => PortType::FlatFace,
        "Workplane.gear_mesh_port" => PortType::GearMesh,
        "Workplane.snap_port" => PortType::SnapFit,
        "Workplane.port" => {
            let word = args.get("type").and_then(Json::as_str).unwrap_or_default();
            let found = ALL.iter().find(|k| k.name == word);
            return match found {
                Some(kind) => Ok(Some(kind)),
                None => {
                    let names: Vec<&str> = ALL.iter().map(|k| k.name).collect();
                    Err(
                        Fault::new(format!("there is no port type '{}'", clip(word)))
                            .hint(format!("port types are {}", names.join(", "))),
                    )
                }
            };
        }
        _ => return Ok(None),
    };
    Ok(Some(port_type.kind()))
}

/// Arguments that bear the names of the port's parameters are in their ranges.
fn ranges(kind: &PortKind, args: &BTreeMap<String, Json>) -> Result<(), Fault> {
    for param in kind.params {
        let Some(value) = args.get(param.name).and_then(Json::as_f64) else {
            continue;
        };
        if !param.allowed.allows(value) {
            return Err(Fault::new(format!(
                "'{}' of a {} port is {}, not {value}",
                param.name,
                kind.name,
                param.expected()
            )));
        }
    }
    Ok(())
}

/// All of a port but its place.
fn whole_port(kind: &PortKind, args: &BTreeMap<String, Json>) -> Result<(), Fault> {
    let params = args
        .get("params")
        .and_then(Json::as_object)
        .into_iter()
        .flatten();
    let port = Port {
        name: String::new(),
        port_type: kind.port_type,
        frame: Frame::WORLD,
        params: params
            .map(|(name, value)| (name.clone(), value.as_f64().unwrap_or(f64::NAN)))
            .collect(),
    };
    let faults = port.faults();
    if faults.is_empty() {
        return Ok(());
    }
    let takes: Vec<&str> = kind.params.iter().map(|p| p.name).collect();
    Err(Fault::new(faults.join("; ")).hint(format!(
        "the parameters of a {} port are {}",
        kind.name,
        takes.join(", ")
    )))
}

/// The teeth that arguments describe.
pub(crate) fn toothing(args: &BTreeMap<String, Json>) -> Result<Toothing, Fault> {
    let number = |name: &str| args.get(name).and_then(Json::as_f64).unwrap_or_default();
    let teeth = args.get("teeth").and_then(Json::as_u64);
    let teeth = teeth.filter(|n| (3..=1000).contains(n));
    let Some(teeth) = teeth.and_then(|n| u32::try_from(n).ok()) else {
        return Err(Fault::new("teeth is 3 to 1000"));
    };
    let module = number("module");
    if module <= 0.0 {
        return Err(Fault::new(format!("module is over 0, not {module}")));
    }
    let pressure_angle_deg = number("pressure_angle_deg");
    if !(5.0..=45.0).contains(&pressure_angle_deg) {
        return Err(Fault::new("pressure_angle_deg is 5 to 45"));
    }
    Ok(Toothing {
        module,
        teeth,
        pressure_angle_deg,
        profile_shift: number("profile_shift"),
        thinning: number("thinning"),
        internal: false,
    })
}
