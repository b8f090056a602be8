//! `measure`.

use assemcad_assembly::{Faults, Workshop};
use assemcad_views::measure::{Measurement, Question, What};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::{Effect, Tool, Weight};

pub(crate) struct Measure;

#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct Arguments {
    /// Name of the assembly.
    assembly: String,
    /// What is measured.
    what: Quantity,
    /// Of what: a part ('plate'), a port ('plate:top_face') or faces of a part by a selector in its own
    /// frame ('plate@>Z'). Left out, centre, box and mass are those of the whole assembly.
    #[serde(default)]
    #[schemars(length(max = 400))]
    of: Option<String>,
    /// To what, for distance and angle; written as 'of' is.
    #[serde(default)]
    #[schemars(length(max = 400))]
    to: Option<String>,
    /// Density for mass, in kg/m3; 7850 (steel) where it is left out.
    #[serde(default)]
    #[schemars(range(min = 0.001, max = 1e5))]
    density_kg_m3: Option<f64>,
}

/// What is measured.
#[derive(Debug, Clone, Copy, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
enum Quantity {
    Distance,
    Angle,
    Centre,
    Box,
    Mass,
}

#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Answer {
    /// The distance: of two parts or faces the smallest one, of two ports that of their origins.
    #[serde(skip_serializing_if = "Option::is_none")]
    distance_mm: Option<f64>,
    /// From the first port's origin to the second's.
    #[serde(skip_serializing_if = "Option::is_none")]
    vector_mm: Option<[f64; 3]>,
    /// Between the two ports' z axes as endless lines.
    #[serde(skip_serializing_if = "Option::is_none")]
    axis_distance_mm: Option<f64>,
    /// A point of each where they are that near.
    #[serde(skip_serializing_if = "Option::is_none")]
    points_mm: Option<[[f64; 3]; 2]>,
    /// The angle between the two directions, 0 to 180; to 90 where one is an axis without a sense.
    #[serde(skip_serializing_if = "Option::is_none")]
    angle_deg: Option<f64>,
    /// The angle between them as lines, 0 to 90.
    #[serde(skip_serializing_if = "Option::is_none")]
    lines_angle_deg: Option<f64>,
    /// The centre of the volume or the area, or the port's origin.
    #[serde(skip_serializing_if = "Option::is_none")]
    centre_mm: Option<[f64; 3]>,
    /// The smallest corner of the box.
    #[serde(skip_serializing_if = "Option::is_none")]
    box_min_mm: Option<[f64; 3]>,
    /// The largest corner of the box.
    #[serde(skip_serializing_if = "Option::is_none")]
    box_max_mm: Option<[f64; 3]>,
    /// The volume.
    #[serde(skip_serializing_if = "Option::is_none")]
    volume_mm3: Option<f64>,
    /// The mass.
    #[serde(skip_serializing_if = "Option::is_none")]
    mass_kg: Option<f64>,
    /// The density that was reckoned with.
    #[serde(skip_serializing_if = "Option::is_none")]
    density_kg_m3: Option<f64>,
    /// How it was measured, and how good it is.
    how: String,
}

impl Tool for Measure {
    type Arguments = Arguments;
    type Answer = Answer;
    const NAME: &'static str = "measure";
    const TITLE: &'static str = "Measure";
    const DESCRIPTION: &'static str = "Measures in the assembly's frame, in mm, degrees and kg: distance or \
        angle between two ports, parts or faces; centre, box or mass of a part, of faces or of the whole \
        assembly. Ports are measured in closed form (centre distance of two gears: distance of their \
        ports, axis_distance_mm), parts and faces by the kernel. An overlap measures as distance 0: \
        verify finds clashes. Nothing is changed.";
    const EFFECT: Effect = Effect::Reads;
    const WEIGHT: Weight = Weight::Usual;

    async fn run(workshop: &Workshop, a: Arguments) -> Result<Answer, Faults> {
        let question = Question {
            what: match a.what {
                Quantity::Distance => What::Distance,
                Quantity::Angle => What::Angle,
                Quantity::Centre => What::Centre,
                Quantity::Box => What::Box,
                Quantity::Mass => What::Mass,
            },
            of: a.of,
            to: a.to,
            density: a.density_kg_m3,
        };
        Ok(workshop.measure(&a.assembly, &question).await?.into())
    }
}

impl From<Measurement> for Answer {
    fn from(m: Measurement) -> Self {
        Self {
            distance_mm: m.distance_mm,
            vector_mm: m.vector_mm,
            axis_distance_mm: m.axis_distance_mm,
            points_mm: m.points_mm,
            angle_deg: m.angle_deg,
            lines_angle_deg: m.lines_angle_deg,
            centre_mm: m.centre_mm,
            box_min_mm: m.box_min_mm,
            box_max_mm: m.box_max_mm,
            volume_mm3: m.volume_mm3,
            mass_kg: m.mass_kg,
            density_kg_m3: m.density_kg_m3,
            how: m.how,
        }
    }
}
