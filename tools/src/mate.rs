//! `mate`.

use assemcad_assembly::edit::Change;
use assemcad_assembly::state::Summary;
use assemcad_assembly::{Faults, Workshop};
use assemcad_model::diagnostic::{Code, Diagnostic};
use assemcad_model::mates::{MateType, Residual};
use assemcad_model::report::rounded;
use assemcad_model::spec::{End, Mate};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value, json};

use crate::{Effect, Tool, Weight};

pub(crate) struct MakeMate;

#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct Arguments {
    /// Name of the assembly.
    assembly: String,
    /// The mate's name, unique in the assembly: letters, digits, '_' and '-', at most 64.
    id: String,
    /// Type of the mate.
    mate_type: MateType,
    /// The port that stays, as 'part:port'.
    base: String,
    /// The port whose part is brought in, as 'part:port'.
    incoming: String,
    /// face_to_face: shift along the base port's x, in mm.
    #[serde(default)]
    u_mm: Option<f64>,
    /// face_to_face: shift along the base port's y, in mm.
    #[serde(default)]
    v_mm: Option<f64>,
    /// snap_to_face: where along the base face's x, 0 to 1; 0.5 is the middle.
    #[serde(default)]
    u: Option<f64>,
    /// snap_to_face: where along the base face's y, 0 to 1.
    #[serde(default)]
    v: Option<f64>,
    /// face_to_face, snap_to_face: gap along the base port's normal, in mm.
    #[serde(default)]
    d_n_mm: Option<f64>,
    /// coaxial, press_fit: distance of the ports' origins along the base port's z, in mm (a bore's z
    /// points out of its mouth: a negative distance goes in). coaxial_face: gap between the seats.
    #[serde(default)]
    d_mm: Option<f64>,
    /// coaxial, press_fit: whether the ports' z axes look against each other ('opposed', the default)
    /// or the same way ('same').
    #[serde(default)]
    direction: Option<Direction>,
    /// thread_engage: length of the thread that is engaged, in mm.
    #[serde(default)]
    d_t_mm: Option<f64>,
    /// thread_engage: how far the screw's end stands out of the hole's far side, in mm.
    #[serde(default)]
    through_mm: Option<f64>,
    /// thread_engage: true leaves the screw motion free, as in a spindle drive.
    #[serde(default)]
    free: Option<bool>,
    /// gear_mesh: module that both gears must have, in mm.
    #[serde(default)]
    m: Option<f64>,
    /// gear_mesh: ratio that they must have, teeth of the incoming by teeth of the base gear.
    #[serde(default)]
    r: Option<f64>,
    /// gear_mesh: direction of the incoming axis from the base port's x, in degrees.
    #[serde(default)]
    angle_deg: Option<f64>,
    /// gear_mesh: play along the pitch circle, in mm; widens the centre distance.
    #[serde(default)]
    backlash_mm: Option<f64>,
    /// Turn about the incoming port's z, in degrees.
    #[serde(default)]
    alpha_deg: Option<f64>,
    /// coaxial, coaxial_face, face_to_face, snap_to_face: what joins the two for good where they touch.
    #[serde(default)]
    bond: Option<Bond>,
    /// Ids of the engineering axioms that justify the mate, such as 'C-02'; find_axioms tells them.
    #[serde(default)]
    axioms: Vec<String>,
}

#[derive(Debug, Clone, Copy, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
enum Direction {
    Opposed,
    Same,
}

#[derive(Debug, Clone, Copy, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
enum Bond {
    None,
    Welded,
    Brazed,
    Soldered,
    Glued,
    Magnetic,
}

#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Answer {
    /// False where the same mate was there already.
    changed: bool,
    /// The mate's name.
    mate: String,
    /// How far the mate is from holding at the parts' places; absent while one of them has no place.
    #[serde(skip_serializing_if = "Option::is_none")]
    residual: Option<Residual>,
    /// The parts that got a place by this mate, and where they reach in the world.
    placed: Vec<PlacedPart>,
    /// The assembly now, in short.
    state: Summary,
}

#[derive(Debug, Serialize, JsonSchema)]
struct PlacedPart {
    /// Name.
    part: String,
    /// Smallest corner of a box around it in the world, in mm.
    box_min_mm: [f64; 3],
    /// Largest corner.
    box_max_mm: [f64; 3],
}

impl Arguments {
    fn options(&self) -> Map<String, Value> {
        let all = [
            ("u_mm", self.u_mm.map(|v| json!(v))),
            ("v_mm", self.v_mm.map(|v| json!(v))),
            ("d_n_mm", self.d_n_mm.map(|v| json!(v))),
            ("d_mm", self.d_mm.map(|v| json!(v))),
            ("direction", self.direction.map(|v| json!(v))),
            ("u", self.u.map(|v| json!(v))),
            ("v", self.v.map(|v| json!(v))),
            ("d_t_mm", self.d_t_mm.map(|v| json!(v))),
            ("through_mm", self.through_mm.map(|v| json!(v))),
            ("free", self.free.map(|v| json!(v))),
            ("m", self.m.map(|v| json!(v))),
            ("r", self.r.map(|v| json!(v))),
            ("angle_deg", self.angle_deg.map(|v| json!(v))),
            ("backlash_mm", self.backlash_mm.map(|v| json!(v))),
            ("alpha_deg", self.alpha_deg.map(|v| json!(v))),
            ("bond", self.bond.map(|v| json!(v))),
        ];
        all.into_iter()
            .filter_map(|(name, v)| Some((name.to_owned(), v?)))
            .collect()
    }
}

impl Tool for MakeMate {
    type Arguments = Arguments;
    type Answer = Answer;
    const NAME: &'static str = "mate";
    const TITLE: &'static str = "Mate two ports";
    const DESCRIPTION: &'static str = "Joins two parts at their ports. face_to_face: faces together; \
        coaxial: axes on one line; coaxial_face: axis and seat (a bolt's head); press_fit: shaft in a \
        hole no wider; thread_engage: screw in thread; gear_mesh: tooth in gap; snap_to_face: a point of \
        a face. The first mate between a part with a place and one without places the latter; one \
        between two placed parts must hold where they are. A port of the wrong type is refused with \
        those that would fit.";
    const EFFECT: Effect = Effect::Adds;
    const WEIGHT: Weight = Weight::Usual;

    async fn run(workshop: &Workshop, a: Arguments) -> Result<Answer, Faults> {
        let options = a.options();
        let (base, incoming) = match (end(&a.base, "base"), end(&a.incoming, "incoming")) {
            (Ok(base), Ok(incoming)) => (base, incoming),
            (base, incoming) => {
                return Err(base.err().into_iter().chain(incoming.err()).collect());
            }
        };
        let mate = Mate {
            id: a.id,
            mate_type: a.mate_type,
            base,
            incoming,
            options,
            axioms: a.axioms,
            notes: String::new(),
        };
        let mated = workshop.mate(&a.assembly, mate).await?;
        Ok(Answer {
            changed: mated.change == Change::Made,
            mate: mated.mate.mate.id.clone(),
            residual: mated.residual.map(|r| Residual {
                distance_mm: rounded(r.distance_mm),
                angle_deg: rounded(r.angle_deg),
            }),
            placed: mated
                .placed
                .into_iter()
                .map(|(part, (min, max))| PlacedPart {
                    part,
                    box_min_mm: min.map(rounded),
                    box_max_mm: max.map(rounded),
                })
                .collect(),
            state: mated.state.into(),
        })
    }
}

fn end(text: &str, place: &str) -> Result<End, Diagnostic> {
    match text.split_once(':') {
        Some((part, port)) if !part.is_empty() && !port.is_empty() => Ok(End {
            part: part.to_owned(),
            port: port.to_owned(),
        }),
        _ => Err(
            Diagnostic::error(Code::ArgumentInvalid, place, "this names no port")
                .found(text)
                .expected("part:port, such as 'plate:top_face'"),
        ),
    }
}
