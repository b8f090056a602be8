//! Measurements in the assembly's frame: of parts, of faces, of ports.

mod reference;

use assemcad_factories::failure::diagnostic;
use assemcad_geometry::Asker;
use assemcad_kernel::asked::Measured;
use assemcad_model::angle::between_deg;
use assemcad_model::diagnostic::{Code, Diagnostic, Faults};
use assemcad_model::frame::Frame;
use assemcad_model::report::{STEEL_KG_M3, rounded};
use assemcad_placing::Partial;
use nalgebra::Vector3;
use serde_json::json;

use reference::{Reference, Target};

/// Directions that differ by less, in degrees, are one.
const PARALLEL_DEG: f64 = 1e-6;

/// What is measured.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum What {
    /// How far apart two things are.
    Distance,
    /// How two directions stand to each other.
    Angle,
    /// The centre of a volume or an area, or a port's origin.
    Centre,
    /// The smallest box along the assembly's axes.
    Box,
    /// Volume times density.
    Mass,
}

/// A question.
#[derive(Debug, Clone, PartialEq)]
pub struct Question {
    /// What is measured.
    pub what: What,
    /// Of what: `part`, `part:port` or `part@faces`; the whole assembly where it is left out.
    pub of: Option<String>,
    /// To what, for distances and angles.
    pub to: Option<String>,
    /// In kg/m3; [`STEEL_KG_M3`] where it is left out.
    pub density: Option<f64>,
}

/// An answer: what has no meaning for the question is left out.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Measurement {
    /// The distance in mm.
    pub distance_mm: Option<f64>,
    /// From the first port's origin to the second's, in mm.
    pub vector_mm: Option<[f64; 3]>,
    /// The distance of the two ports' z axes taken as endless lines, in mm.
    pub axis_distance_mm: Option<f64>,
    /// Where the two are that near, in mm.
    pub points_mm: Option<[[f64; 3]; 2]>,
    /// The angle between two directions in degrees.
    pub angle_deg: Option<f64>,
    /// The angle between them as lines without a sense, 0 to 90 degrees.
    pub lines_angle_deg: Option<f64>,
    /// The centre in mm.
    pub centre_mm: Option<[f64; 3]>,
    /// The smallest corner of the box in mm.
    pub box_min_mm: Option<[f64; 3]>,
    /// The largest corner of the box in mm.
    pub box_max_mm: Option<[f64; 3]>,
    /// The volume in mm3.
    pub volume_mm3: Option<f64>,
    /// The mass in kg.
    pub mass_kg: Option<f64>,
    /// The density that was reckoned with, in kg/m3.
    pub density_kg_m3: Option<f64>,
    /// How it was measured, and how good it is.
    pub how: String,
}

impl Question {
    /// What can be told of a question before anything is made.
    ///
    /// # Errors
    /// When it names too many things or too few.
    pub fn check(&self) -> Result<(), Faults> {
        let pair = matches!(self.what, What::Distance | What::Angle);
        for (place, there, needed) in [
            ("of", self.of.is_some(), pair),
            ("to", self.to.is_some(), pair),
        ] {
            if needed && !there {
                return Err(vec![Diagnostic::error(
                    Code::ArgumentInvalid,
                    place,
                    format!("a distance or an angle is between two things: '{place}' is missing"),
                )]);
            }
        }
        if !pair && self.to.is_some() {
            return Err(vec![
                Diagnostic::error(
                    Code::ArgumentInvalid,
                    "to",
                    "only a distance or an angle goes to something",
                )
                .hint("leave out 'to', or ask for what: distance"),
            ]);
        }
        Ok(())
    }
}

/// Measures an assembly, as far as it can be made and placed.
///
/// # Errors
/// When what is asked for is not there, has no place, or has no such measure.
pub async fn measure(
    door: Asker<'_>,
    part: &Partial,
    question: &Question,
) -> Result<Measurement, Faults> {
    question.check()?;
    let (mut targets, mut faults) = (Vec::new(), Vec::new());
    for (place, text) in [("of", &question.of), ("to", &question.to)] {
        if let Some(text) = text {
            match Reference::find(part, text, place) {
                Ok(target) => targets.push(target),
                Err(d) => faults.push(d),
            }
        }
    }
    if !faults.is_empty() {
        return Err(faults);
    }
    let answer = match (question.what, targets.as_slice()) {
        (What::Distance, [a, b]) => distance(door, a, b).await,
        (What::Angle, [a, b]) => angle(door, a, b).await,
        (_, []) => whole(door, part, question).await,
        (_, [one, ..]) => single(door, one, question).await,
    };
    answer.map_err(|d| vec![d])
}

async fn distance(
    door: Asker<'_>,
    a: &Reference,
    b: &Reference,
) -> Result<Measurement, Diagnostic> {
    let (one, two) = match (&a.target, &b.target) {
        (Target::Port(p), Target::Port(q)) => return Ok(between_ports(p, q)),
        (Target::Solid(one), Target::Solid(two)) => (one, two),
        _ => {
            return Err(Diagnostic::error(
                Code::ArgumentInvalid,
                "to",
                "a distance is between two ports, or between two parts or faces",
            )
            .found(json!([a.text, b.text]))
            .hint("name a face of the port's part instead of the port, as in part@>Z"));
        }
    };
    let found = door.distance(one, two).await;
    let found = found.map_err(|f| diagnostic(&f, &format!("'{}' and '{}'", a.text, b.text)))?;
    Ok(Measurement {
        distance_mm: Some(rounded(found.distance)),
        points_mm: Some([found.on_a, found.on_b].map(|p| p.map(coarse))),
        how: "the kernel's smallest distance; 0 where the two touch or overlap (verify tells \
              which); the points where they are that near are good to 0.0001 mm, and there may \
              be others"
            .to_owned(),
        ..Measurement::default()
    })
}

async fn angle(door: Asker<'_>, a: &Reference, b: &Reference) -> Result<Measurement, Diagnostic> {
    let (one, two) = (
        direction(door, a, "of").await?,
        direction(door, b, "to").await?,
    );
    let angle = between_deg(&one.along, &two.along);
    let lines = angle.min(180.0 - angle);
    let sense = one.sense && two.sense;
    Ok(Measurement {
        angle_deg: Some(rounded(if sense { angle } else { lines })),
        lines_angle_deg: Some(rounded(lines)),
        how: format!(
            "between {} and {}{}",
            one.what,
            two.what,
            if sense {
                ""
            } else {
                "; an axis has no sense, so the angle is at most 90"
            }
        ),
        ..Measurement::default()
    })
}

/// The direction of a port or of faces.
async fn direction(door: Asker<'_>, of: &Reference, place: &str) -> Result<Direction, Diagnostic> {
    let solid = match &of.target {
        Target::Port(frame) => {
            return Ok(Direction {
                along: frame.z.into(),
                sense: true,
                what: format!("z of {}", of.text),
            });
        }
        Target::Solid(solid) => solid,
    };
    let none = |why: &str| {
        Diagnostic::error(Code::ArgumentInvalid, place, format!("'{}' {why}", of.text))
            .hint("name a port (part:port), or faces with one direction (part@>Z)")
    };
    if solid.faces.is_none() {
        return Err(none("is a part, and a part has no direction of its own"));
    }
    let measured = measured(door, of).await?;
    let mut found: Option<Direction> = None;
    for face in &measured.faces {
        let Some(along) = face.direction.map(Vector3::from) else {
            return Err(none(&format!(
                "means a face of form {}, which has no direction",
                face.form
            )));
        };
        let sense = face.form == "PLANE";
        if let Some(first) = &found {
            let off = between_deg(&first.along, &along);
            let off = if sense && first.sense {
                off
            } else {
                off.min(180.0 - off)
            };
            if off > PARALLEL_DEG {
                return Err(none("means faces of different directions"));
            }
        }
        let what = if sense {
            "the outward normal"
        } else {
            "the axis"
        };
        found = found.or(Some(Direction {
            along,
            sense,
            what: format!("{what} of {}", of.text),
        }));
    }
    found.ok_or_else(|| none("means no face"))
}

/// Centre, box or mass of one thing.
async fn single(
    door: Asker<'_>,
    of: &Reference,
    question: &Question,
) -> Result<Measurement, Diagnostic> {
    let refused = |what: &str| {
        Diagnostic::error(
            Code::ArgumentInvalid,
            "of",
            format!("'{}' is no part, and has no {what}", of.text),
        )
        .found(of.text.as_str())
        .hint("name the part alone")
    };
    if let Target::Port(frame) = &of.target {
        return match question.what {
            What::Centre => Ok(Measurement {
                centre_mm: Some(frame.origin.map(rounded)),
                how: "the port's origin".to_owned(),
                ..Measurement::default()
            }),
            What::Box => Err(refused("box")),
            _ => Err(refused("mass")),
        };
    }
    let measured = measured(door, of).await?;
    match question.what {
        What::Centre => Ok(Measurement {
            centre_mm: Some(measured.centre.map(rounded)),
            how: match measured.volume {
                Some(_) => "centre of the part's volume".to_owned(),
                None => format!("centre of the area of {} faces", measured.faces.len()),
            },
            ..Measurement::default()
        }),
        What::Box => Ok(boxed(&[measured])),
        _ if measured.volume.is_none() => Err(refused("mass")),
        _ => Ok(weighed(&[measured], question)),
    }
}

/// Centre, box or mass of the whole assembly: only where all of it is known.
async fn whole(
    door: Asker<'_>,
    part: &Partial,
    question: &Question,
) -> Result<Measurement, Diagnostic> {
    if let Some(first) = part.missing.first() {
        return Err(Diagnostic::error(
            Code::Indeterminate,
            "assembly",
            format!("the whole assembly is not known: {first}"),
        )
        .found(json!(part.missing))
        .hint("name one part, or mend what verify finds"));
    }
    let mut all = Vec::new();
    for each in &part.resolved.parts {
        let reference = Reference::find(part, &each.id, "of")?;
        all.push(measured(door, &reference).await?);
    }
    Ok(match question.what {
        What::Box => boxed(&all),
        What::Centre => Measurement {
            centre_mm: Some(centre(&all).map(rounded)),
            how: format!(
                "centre of the volume of all {} parts, of one density",
                all.len()
            ),
            ..Measurement::default()
        },
        _ => weighed(&all, question),
    })
}

async fn measured(door: Asker<'_>, of: &Reference) -> Result<Measured, Diagnostic> {
    let Target::Solid(solid) = &of.target else {
        return Err(Diagnostic::error(
            Code::Internal,
            &of.text,
            "a port has no solid",
        ));
    };
    let measured = door.measure(solid).await;
    measured.map_err(|f| diagnostic(&f, &format!("'{}'", of.text)))
}

/// A direction in the assembly's frame, and whether it has a sense.
struct Direction {
    along: Vector3<f64>,
    sense: bool,
    what: String,
}

fn between_ports(a: &Frame, b: &Frame) -> Measurement {
    let (p, q) = (Vector3::from(a.z), Vector3::from(b.z));
    let arm = Vector3::from(b.origin) - Vector3::from(a.origin);
    let normal = p.cross(&q);
    // Parallel lines are as far apart as the one's point is off the other.
    let axes = if normal.norm() < 1e-9 {
        (arm - p * arm.dot(&p)).norm()
    } else {
        (arm.dot(&normal) / normal.norm()).abs()
    };
    Measurement {
        distance_mm: Some(rounded(arm.norm())),
        vector_mm: Some([arm.x, arm.y, arm.z].map(rounded)),
        axis_distance_mm: Some(rounded(axes)),
        how:
            "between the ports' origins, in closed form; axis_distance_mm between their z axes as \
              endless lines"
                .to_owned(),
        ..Measurement::default()
    }
}

fn boxed(all: &[Measured]) -> Measurement {
    let fold = |pick: fn(f64, f64) -> f64, of: fn(&Measured) -> [f64; 3]| {
        let mut corners = all.iter().map(of);
        let first = corners.next().unwrap_or_default();
        corners.fold(first, |mut sum, corner| {
            for (s, c) in sum.iter_mut().zip(corner) {
                *s = pick(*s, c);
            }
            sum
        })
    };
    Measurement {
        box_min_mm: Some(fold(f64::min, |m| m.min).map(rounded)),
        box_max_mm: Some(fold(f64::max, |m| m.max).map(rounded)),
        how:
            "the tight box along the assembly's axes; extremes of free-form faces are searched for"
                .to_owned(),
        ..Measurement::default()
    }
}

fn volume(all: &[Measured]) -> f64 {
    all.iter().filter_map(|m| m.volume).sum()
}

fn centre(all: &[Measured]) -> [f64; 3] {
    let mut moment = Vector3::zeros();
    for m in all {
        moment += Vector3::from(m.centre) * m.volume.unwrap_or_default();
    }
    (moment / volume(all)).into()
}

fn weighed(all: &[Measured], question: &Question) -> Measurement {
    let (density, said) = match question.density {
        Some(density) => (density, "as stated"),
        None => (STEEL_KG_M3, "of steel, since none was stated"),
    };
    let volume = volume(all);
    Measurement {
        volume_mm3: Some(rounded(volume)),
        // 1 mm3 is 1e-9 m3.
        mass_kg: Some(rounded(volume * 1e-9 * density)),
        density_kg_m3: Some(density),
        centre_mm: Some(centre(all).map(rounded)),
        how: format!(
            "volume times a density of {density} kg/m3, {said}; the volume is the sum of the parts'"
        ),
        ..Measurement::default()
    }
}

/// As good as the kernel's witness points are.
fn coarse(x: f64) -> f64 {
    libm::round(x * 1e4) / 1e4 + 0.0
}
