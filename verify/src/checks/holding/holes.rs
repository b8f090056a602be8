//! Holes of parts that lie on each other: those that meet at the common face are in line, whether a mate or a screw
//! goes through them or not.

use std::collections::BTreeMap;

use assemcad_facts::{Held, PairMeetings};
use assemcad_geometry::Asker;
use assemcad_geometry::narrow::Boundary;
use assemcad_geometry::narrow::meet::Kind;
use assemcad_kernel::skin::{SkinCurve, SkinSurface};
use assemcad_model::diagnostic::{Code, Diagnostic};
use assemcad_model::report::{Finding, Verdict, rounded};
use assemcad_placing::Assembled;
use nalgebra::Vector3;
use serde_json::{Map, json};

type V = Vector3<f64>;

/// How far the end of a hole may be off the face that two parts lie on, in mm.
const AT_FACE_MM: f64 = 0.01;

/// How far round holes may be out of line beyond what the wider one gives way, in mm. Ours.
const OUT_OF_LINE_MM: f64 = 0.05;

/// A round hole that ends at a face.
struct Hole {
    centre: V,
    radius: f64,
}

/// Holes that overlap in part only.
pub(super) async fn told(
    door: Asker<'_>,
    assembled: &Assembled<'_>,
    held: &Held,
    pairs: &[PairMeetings],
) -> Vec<Finding> {
    let body_of = super::loose::body_of(held);
    let mut bored = Bored::default();
    let mut out = Vec::new();
    for pair in pairs {
        // Parts that move against each other have holes that pass each other.
        if body_of.get(&pair.a) != body_of.get(&pair.b) {
            continue;
        }
        let flat = pair
            .meetings
            .iter()
            .filter(|m| m.kind == Kind::Plane && m.touches());
        let mut seen: Vec<(V, V)> = Vec::new();
        for meeting in flat {
            let Some(spot) = meeting.spots.first() else {
                continue;
            };
            let (at, normal) = (V::from(spot.at), V::from(spot.normal));
            let same =
                |(p, n): &(V, V)| (p - at).dot(&normal).abs() < 1e-3 && n.dot(&normal) > 0.99;
            if seen.iter().any(same) {
                continue;
            }
            seen.push((at, normal));
            let one = bored.at(door, assembled, pair.a, (&at, &normal)).await;
            let two = bored.at(door, assembled, pair.b, (&at, &normal)).await;
            for a in &one {
                for b in &two {
                    let off = (a.centre - b.centre).norm();
                    let room = (a.radius - b.radius).abs() + OUT_OF_LINE_MM;
                    if off > room && off < a.radius + b.radius - OUT_OF_LINE_MM {
                        out.push(finding(assembled, (pair.a, a), (pair.b, b), off));
                    }
                }
            }
        }
    }
    grouped(out)
}

/// One finding for each pair of parts, however many holes.
fn grouped(all: Vec<Finding>) -> Vec<Finding> {
    let mut out: Vec<Finding> = Vec::new();
    for f in all {
        match out.iter_mut().find(|o| o.parts == f.parts) {
            Some(first) => {
                let more = first
                    .values
                    .get("more_holes")
                    .and_then(serde_json::Value::as_u64);
                first
                    .values
                    .insert("more_holes".to_owned(), json!(more.unwrap_or(0) + 1));
            }
            None => out.push(f),
        }
    }
    out
}

/// Round holes of solids, in their own frames, once for each solid.
#[derive(Default)]
struct Bored(BTreeMap<String, Vec<Bore>>);

/// A round hole in its solid's frame: its ends on the axis, the direction, the radius.
struct Bore {
    ends: [[f64; 3]; 2],
    axis: [f64; 3],
    radius: f64,
}

impl Bored {
    /// The holes of a placed part that end at a face, which a point and a normal give.
    async fn at(
        &mut self,
        door: Asker<'_>,
        assembled: &Assembled<'_>,
        part: usize,
        (at, normal): (&V, &V),
    ) -> Vec<Hole> {
        let Some(placed) = assembled.solid(part) else {
            return Vec::new();
        };
        let key = placed.solid.hash().to_owned();
        if !self.0.contains_key(&key) {
            let skin = door.skin(&placed.solid).await;
            let found = skin.map(|s| bores(&s)).unwrap_or_default();
            self.0.insert(key.clone(), found);
        }
        let bores = self.0.get(&key).into_iter().flatten();
        let there = bores.filter_map(|b| {
            let along = V::from(placed.at.direction(b.axis));
            if along.cross(normal).norm() > 1e-6 {
                return None;
            }
            let ends = b.ends.map(|e| V::from(placed.at.point(e)));
            let mut ends = ends.into_iter();
            let centre = ends.find(|e| (e - at).dot(normal).abs() <= AT_FACE_MM)?;
            Some(Hole {
                centre,
                radius: b.radius,
            })
        });
        there.collect()
    }
}

/// The holes that go all the way round.
fn bores(of: &Boundary) -> Vec<Bore> {
    let skin = of.skin();
    let whole = |e: &u32| {
        let curve = skin.edges.get(*e as usize).map(|e| e.curve);
        matches!(curve, Some(SkinCurve::Circle { sweep, .. }) if sweep >= core::f64::consts::TAU - 1e-6)
    };
    let faces = skin
        .faces
        .iter()
        .filter(|f| !f.outward && f.edges.iter().any(whole));
    faces
        .filter_map(|face| match face.surface {
            SkinSurface::Cylinder {
                origin,
                axis,
                radius,
                range,
            } => Some(Bore {
                ends: range.map(|z| (V::from(origin) + V::from(axis) * z).into()),
                axis,
                radius,
            }),
            _ => None,
        })
        .collect()
}

fn finding(
    assembled: &Assembled<'_>,
    (a, one): (usize, &Hole),
    (b, two): (usize, &Hole),
    off: f64,
) -> Finding {
    let (name_a, name_b) = (assembled.resolved.name(a), assembled.resolved.name(b));
    let at = <[f64; 3]>::from(one.centre).map(rounded);
    let mut values = Map::new();
    values.insert("out_of_line_mm".to_owned(), json!(rounded(off)));
    values.insert("at_mm".to_owned(), json!(at));
    let d = Diagnostic::error(
        Code::HolesOutOfLine,
        format!("parts '{name_a}' and '{name_b}'"),
        format!(
            "where '{name_a}' and '{name_b}' lie on each other, at {}, a hole of {} mm and one of {} mm are {} mm out \
             of line",
            json!(at),
            rounded(2.0 * one.radius),
            rounded(2.0 * two.radius),
            rounded(off)
        ),
    )
    .found(rounded(off))
    .expected("holes that meet at a common face in line, or one of them as wide as the other is off")
    .hint("move the holes of one part, or the offsets of the mate that lays the parts on each other");
    Finding {
        verdict: Verdict::Fail,
        check: super::CHECK.to_owned(),
        parts: vec![name_a, name_b],
        mates: Vec::new(),
        values,
        axioms: Vec::new(),
        diagnostic: d,
    }
}
