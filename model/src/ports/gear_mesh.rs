//! `GEAR_MESH`.

use core::f64::consts::PI;

use super::{Allowed, PortKind, PortParam, PortType, Values, length};
use crate::probe::{Probe, Site, Test, probe};

pub(super) static KIND: PortKind = PortKind {
    port_type: PortType::GearMesh,
    name: "GEAR_MESH",
    doc: "The teeth of a gear. Origin: on the gear's axis at half the face width; z along the axis; x \
          through the middle of a tooth, of an internal gear too.",
    params: &[
        PortParam {
            name: "module",
            unit: "mm",
            allowed: Allowed::Between(0.01, 100.0),
            optional: None,
            doc: "normal module",
        },
        PortParam {
            name: "teeth",
            unit: "",
            allowed: Allowed::Whole(4.0, 2000.0),
            optional: None,
            doc: "number of teeth",
        },
        PortParam {
            name: "pressure_angle_deg",
            unit: "deg",
            allowed: Allowed::Between(10.0, 35.0),
            optional: None,
            doc: "normal pressure angle",
        },
        PortParam {
            name: "helix_angle_deg",
            unit: "deg",
            allowed: Allowed::Between(-60.0, 60.0),
            optional: None,
            doc: "helix angle at the pitch cylinder; positive is right-handed, 0 is a spur gear",
        },
        PortParam {
            name: "width",
            ..length("face width")
        },
        PortParam {
            name: "internal",
            unit: "",
            allowed: Allowed::OneOf(&[0.0, 1.0]),
            optional: None,
            doc: "1 for a ring with its teeth inside, otherwise 0",
        },
        PortParam {
            name: "profile_shift",
            unit: "",
            allowed: Allowed::Between(-1.0, 2.0),
            optional: Some(0.0),
            doc: "profile shift in modules",
        },
        PortParam {
            name: "thinning",
            unit: "mm",
            allowed: Allowed::Between(0.0, 50.0),
            optional: Some(0.0),
            doc: "what every tooth is thinner for backlash, along the pitch circle",
        },
    ],
    rule,
    evidence,
};

fn rule(v: &Values<'_>) -> Vec<String> {
    let half = half_thickness(v);
    if half > 0.05 && half < 0.45 {
        return Vec::new();
    }
    vec![format!(
        "'profile_shift' and 'thinning' of a GEAR_MESH port leave a tooth of {} pitches at the pitch circle",
        2.0 * half
    )]
}

/// The radius of the pitch cylinder in mm: `m z / (2 cos beta)`, from the normal module (ISO 21771).
pub(crate) fn pitch_radius(module: f64, teeth: f64, helix_deg: f64) -> f64 {
    module * teeth / (2.0 * crate::angle::sin_cos_deg(helix_deg).1)
}

/// Half a tooth's thickness at the pitch circle in pitches: `1/4 + x tan(alpha) / pi` by ISO 21771 (a ring's
/// teeth are the gaps of that profile, so that the sign turns), less half of the thinning.
fn half_thickness(v: &Values<'_>) -> f64 {
    let (sin, cos) = crate::angle::sin_cos_deg(v.get("pressure_angle_deg"));
    let sign = if v.get("internal") == 1.0 { -1.0 } else { 1.0 };
    let shift = sign * v.get("profile_shift") * sin / cos;
    0.25 + shift / PI - v.get("thinning") / (2.0 * PI * v.get("module"))
}

/// Points at seven tenths of a tooth's half thickness off its middle lie in the tooth, those three tenths
/// into the half gap and beyond in the gap: that fixes the phase and the number of the teeth.
fn evidence(v: &Values<'_>, site: &Site) -> Vec<Probe> {
    let teeth = v.get("teeth");
    let helix = v.get("helix_angle_deg");
    let radius = pitch_radius(v.get("module"), teeth, helix);
    let (sin, cos) = crate::angle::sin_cos_deg(helix);
    let half = half_thickness(v);
    // Beyond the tips: a disc or ring that reaches on there is no gear of this kind.
    let (module, shift) = (v.get("module"), v.get("profile_shift"));
    let past = if v.get("internal") == 1.0 {
        radius - module * (1.3 + shift.abs())
    } else {
        radius + module * (1.3 + shift)
    };
    let (within, beyond) = (0.7 * half, half + 0.3 * (0.5 - half));
    let mut out = Vec::new();
    for share in [0.0, 0.45, -0.45] {
        let z = share * v.get("width");
        // A right-handed helix turns with z: by the arc z tan(beta) at the pitch cylinder.
        let turn = z * (sin / cos) / radius * 180.0 / PI;
        for k in 0..8 {
            // Eight teeth spread around, so that a wrong number of teeth cannot fit them all.
            let tooth = libm::floor(f64::from(k) * teeth / 8.0);
            let point = site.polar(past.max(0.0), tooth * 360.0 / teeth + turn, z);
            out.push(probe("nothing beyond a tooth's tip", Test::Out { point }));
            for part in [0.0, within, -within, 0.5, beyond, -beyond] {
                let point = site.polar(radius, (tooth + part) * 360.0 / teeth + turn, z);
                out.push(if part.abs() <= within {
                    probe("a tooth at the pitch circle", Test::In { point })
                } else {
                    probe("a gap at the pitch circle", Test::Out { point })
                });
            }
        }
    }
    out
}
