//! What the checks want to have measured: which bores, fasteners, shafts and set screws are looked at, and how.
//! Who measures asks here, so that question and verdict keep the same rules.

use assemcad_model::frame::Placement;
use assemcad_model::mates::MateType;
use assemcad_model::ports::PortType;

use crate::class::Class;
use crate::facts::{MateFacts, PartFacts, Side};
use crate::geometry::{NEAR_MM, collinear};
use crate::indexed::Indexed;
use crate::joints::{ends, is_cylinder, is_hole, reach_along, screwed};

/// A bore whose wall is judged.
#[derive(Debug, Clone, Copy)]
pub struct Bore<'a> {
    /// Part and port.
    pub hole: Side<'a>,
    /// The least wall, in mm.
    pub least_mm: f64,
}

/// The least wall around a bore, in diameters of the bore. Ours: a tenth is where workshops stop calling a
/// part a hub or housing and call it a sleeve.
const WALL: f64 = 0.1;

/// The bores of parts that are made to carry something in them; rings, washers, nuts and thin sleeves are
/// thin on purpose, and of a part of a user's factory nothing is known unless a bearing sits in it. The two
/// mouths of a through bore are one bore.
#[must_use]
pub fn bores(facts: &Indexed) -> Vec<Bore<'_>> {
    let mut out: Vec<Bore<'_>> = Vec::new();
    for part in &facts.parts {
        // The bores of this part, with their inverse frames.
        let mut own: Vec<(Bore<'_>, Option<Placement>)> = Vec::new();
        for port in part.ports.iter().filter(|p| is_hole(p.port_type)) {
            let hole = Side { part, port };
            let at = port.frame.placement().ok();
            let wide = |other: &Bore<'_>| {
                (other.hole.port.value("diameter") - port.value("diameter")).abs() < NEAR_MM
            };
            let same = |(other, back): &(Bore<'_>, Option<Placement>)| {
                wide(other)
                    && back.zip(at).is_some_and(|(a, b)| collinear(&(a * b)))
                    && overlaps(&other.hole, &hole)
            };
            if carries_in_bores(facts, &hole) && !own.iter().any(same) {
                let bore = Bore {
                    hole,
                    least_mm: WALL * port.value("diameter"),
                };
                own.push((bore, at.map(|a| a.inverse())));
            }
        }
        out.extend(own.into_iter().map(|(bore, _)| bore));
    }
    out
}

/// Whether two holes on one line have some length in common.
fn overlaps(one: &Side<'_>, two: &Side<'_>) -> bool {
    let own = one.port.value("depth");
    match reach_along(one, two) {
        Some((low, high)) => low.max(-own) < high.min(0.0),
        None => true,
    }
}

fn carries_in_bores(facts: &Indexed, hole: &Side<'_>) -> bool {
    match hole.part.class() {
        Class::Boss | Class::Coupling | Class::Flange | Class::Housing | Class::SpurGear => true,
        Class::Custom => facts.mates_of(&hole.part.id).any(|m| {
            facts
                .seen_from(&hole.part.id, m)
                .is_some_and(|(own, other)| {
                    own.port.name == hole.port.name
                        && other.part.class() == Class::BallBearing
                        && other.is(PortType::PressFit)
                })
        }),
        _ => false,
    }
}

/// The cylinder that a fastener's tool needs.
#[derive(Debug, Clone)]
pub struct Tool<'a> {
    /// The fastener.
    pub fastener: &'a PartFacts,
    /// The port whose axis the tool has; it comes along the port's z, against it.
    pub port: &'a assemcad_model::ports::Port,
    /// Diameter of the cylinder, in mm.
    pub diameter_mm: f64,
    /// Length of the cylinder from the fastener's own end on, in mm.
    pub length_mm: f64,
    /// Parts that may be in the tool: a nut's screw in the socket, and the hole of a set screw.
    pub inside: Vec<&'a str>,
}

/// Width of the tool in widths of the head. Ours: what covers the head itself keeps out every tool that comes
/// along the axis. A socket is wider, but where it does not go round the head a spanner may come from the
/// side.
const WIDTH: f64 = 1.0;

/// Length of the tool in widths of the head. Ours: a bit with its holder, or a short key.
const LENGTH: f64 = 3.0;

/// Width of a set screw's key in diameters of its thread. Ours: about the hexagon socket of set screws.
const KEY: f64 = 0.5;

/// The fasteners that a tool has to reach: bolts, nuts, set screws, and parts of a user's factory with a seat
/// and a screw's thread on one axis.
#[must_use]
pub fn tools(facts: &Indexed) -> Vec<Tool<'_>> {
    let threads = Threads::new(facts);
    let each = facts.parts.iter();
    each.filter_map(|p| tool(&threads, p)).collect()
}

/// The placed threads of all parts, with the points of their axes: part, port and frame.
struct Threads<'a> {
    external: Vec<(Side<'a>, Placement)>,
    internal: Vec<(Side<'a>, Placement)>,
}

impl<'a> Threads<'a> {
    fn new(facts: &'a Indexed) -> Self {
        let of = |wanted: PortType| {
            let all = facts.parts.iter().flat_map(|part| {
                let ports = part.ports.iter().filter(move |p| p.port_type == wanted);
                ports.map(move |port| Side { part, port })
            });
            all.filter_map(|s| Some((s, s.world()?))).collect()
        };
        Self {
            external: of(PortType::ThreadExternal),
            internal: of(PortType::ThreadInternal),
        }
    }

    /// The other parts with a thread on the axis of a port, in their order.
    fn on_axis(&self, own: &Side<'a>, wanted: Option<PortType>) -> Vec<&'a str> {
        let all = match wanted {
            Some(PortType::ThreadExternal) => &self.external,
            Some(PortType::ThreadInternal) => &self.internal,
            _ => return Vec::new(),
        };
        let Some(back) = own.world().map(|w| w.inverse()) else {
            return Vec::new();
        };
        let there = |(other, at): &&(Side<'a>, Placement)| {
            other.part.id != own.part.id && collinear(&(back * *at))
        };
        let mut out: Vec<&str> = all
            .iter()
            .filter(there)
            .map(|(other, _)| other.part.id.as_str())
            .collect();
        out.dedup();
        out
    }
}

fn tool<'a>(threads: &Threads<'a>, part: &'a PartFacts) -> Option<Tool<'a>> {
    let of = |t: PortType| part.ports.iter().find(move |p| p.port_type == t);
    let screw = || {
        let (seat, thread) = (of(PortType::BoltSeat)?, of(PortType::ThreadExternal)?);
        let (s, t) = (seat.frame.placement().ok()?, thread.frame.placement().ok()?);
        collinear(&(s.inverse() * t)).then_some(seat)
    };
    let (port, width) = match part.class() {
        Class::Bolt | Class::Nut => {
            let seat = of(PortType::BoltSeat)?;
            (seat, WIDTH * seat.value("outer_diameter"))
        }
        Class::Custom => {
            let seat = screw()?;
            (seat, WIDTH * seat.value("outer_diameter"))
        }
        Class::SetScrew => {
            let thread = of(PortType::ThreadExternal)?;
            (thread, KEY * thread.value("diameter"))
        }
        _ => return None,
    };
    // What has its own thread on the tool's axis: the screw in a nut, the hole of a set screw.
    let wanted = match part.class() {
        Class::Nut => Some(PortType::ThreadExternal),
        Class::SetScrew => Some(PortType::ThreadInternal),
        _ => None,
    };
    let own = Side { part, port };
    Some(Tool {
        fastener: part,
        port,
        diameter_mm: width,
        length_mm: LENGTH * width,
        inside: threads.on_axis(&own, wanted),
    })
}

/// A shaft in bearings.
#[derive(Debug, Clone, Copy)]
pub struct Carried<'a> {
    /// The shaft, by one of its seats.
    pub shaft: Side<'a>,
    /// The first mate with a bearing.
    pub mate: &'a MateFacts,
}

/// The most end play at one stop of a shaft, in mm. Ours: more is no location but a catch. What stops a part only
/// farther away need not be measured more closely.
pub const END_PLAY_MM: f64 = 1.0;

/// The shafts that sit in bearings.
#[must_use]
pub fn shafts_in_bearings(facts: &Indexed) -> Vec<Carried<'_>> {
    let on_ring = |part: &PartFacts| {
        facts.mates_of(&part.id).find_map(|mate| {
            let (own, other) = facts.seen_from(&part.id, mate)?;
            let sits = is_cylinder(own.port.port_type) && other.is(PortType::Bore);
            (sits && other.part.class() == Class::BallBearing)
                .then_some(Carried { shaft: own, mate })
        })
    };
    facts
        .parts
        .iter()
        .filter(|p| turns(facts, p))
        .filter_map(on_ring)
        .collect()
}

/// Whether a part is a rotating one: a shaft, or one of a user's factory that sits in a bearing's inner ring
/// and is joined to nothing but by its cylinders and teeth. One that is fastened to something is an axle that
/// stands still.
#[must_use]
pub fn turns(facts: &Indexed, part: &PartFacts) -> bool {
    if facts.root() == Some(&part.id) {
        return false;
    }
    let sides = || {
        let mates = facts.mates_of(&part.id);
        mates.filter_map(|m| facts.seen_from(&part.id, m))
    };
    match part.class() {
        Class::Shaft => true,
        Class::Custom => {
            let round = |t| is_cylinder(t) || is_hole(t) || t == PortType::GearMesh;
            sides().all(|(own, _)| round(own.port.port_type))
                && sides().any(|(own, other)| {
                    is_cylinder(own.port.port_type)
                        && other.is(PortType::Bore)
                        && other.part.class() == Class::BallBearing
                })
        }
        _ => false,
    }
}

/// A set screw whose tip presses on a shaft.
#[derive(Debug, Clone, Copy)]
pub struct Tip<'a> {
    /// The mate that screws it into the hub.
    pub mate: &'a MateFacts,
    /// The screw's thread: its origin is the tip.
    pub screw: Side<'a>,
    /// The shaft's seat in the hub.
    pub shaft: Side<'a>,
}

/// The set screws that hold hubs: a screw without a head, in a hub's thread whose axis meets that of the
/// shaft in the hub's bore at a right angle.
#[must_use]
pub fn tips(facts: &Indexed) -> Vec<Tip<'_>> {
    let mut out = Vec::new();
    for s in screwed(facts) {
        let head = |p: &assemcad_model::ports::Port| p.port_type == PortType::BoltSeat;
        if s.screw.part.ports.iter().any(head) {
            continue;
        }
        let shaft = facts.mates_of(&s.hole.part.id).find_map(|m| {
            if !matches!(m.mate_type, MateType::Coaxial | MateType::PressFit) {
                return None;
            }
            let (hole, shaft) = ends(facts, m, is_hole, is_cylinder)?;
            let across = shaft.sees(&s.hole)?;
            let [_, _, z] = across.axes();
            let o = across.origin();
            // The distance of two lines at a right angle: across both.
            let off = (o.x * z.y - o.y * z.x).abs();
            let meets = z.z.abs() <= NEAR_MM && off <= shaft.port.value("diameter") / 2.0;
            (hole.part.id == s.hole.part.id && meets).then_some(shaft)
        });
        out.extend(shaft.map(|shaft| Tip {
            mate: s.mate,
            screw: s.screw,
            shaft,
        }));
    }
    out
}
