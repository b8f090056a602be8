//! Two solids held against each other.

use std::collections::BTreeMap;

use assemcad_model::frame::Placement;
use parry3d_f64::bounding_volume::{Aabb, BoundingVolume};

use super::beside::beside;
use super::boundary::{Boundary, Chain, aabb};
use super::edgewise::between;
use super::inside::contains;
use super::patch::{Patch, Surface, V};
use super::side::outside;
use super::triangles::{apart, between_segments};

/// What two solids have in common.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Common {
    /// Nothing with a volume: they are apart, or touch.
    Nothing,
    /// Not decided here.
    Open,
}

/// Pieces whose normals differ by less than about 32 degrees look the same way: where faces touch with their
/// materials on the same side they are equal, and triangles are off by at most 10 degrees each.
const SAME_WAY: f64 = 0.85;

/// Holds two solids against each other, the second placed in the frame of the first.
#[must_use]
pub fn common(a: &Boundary, b: &Boundary, at: &Placement) -> Common {
    decide(a, b, at, &|_| false).unwrap_or(Common::Open)
}

/// The space about an axis in which two solids may overlap, as threads and press fits do.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sleeve {
    /// A point of the axis, in mm.
    pub point: [f64; 3],
    /// Unit direction of the axis.
    pub direction: [f64; 3],
    /// How far it reaches about the axis, in mm.
    pub radius: f64,
}

impl Sleeve {
    pub(super) fn holds(&self, point: &V) -> bool {
        let arm = point - V::from(self.point);
        super::patch::across(&arm, &V::from(self.direction)).norm() <= self.radius
    }
}

/// As [`common`], but for what lies within some sleeves: where a triangle of either lies there whole, so does all
/// that it has in common with the other.
#[must_use]
pub fn common_beside(a: &Boundary, b: &Boundary, at: &Placement, sleeves: &[Sleeve]) -> Common {
    let meant = |t: &[V; 3]| sleeves.iter().any(|s| t.iter().all(|p| s.holds(p)));
    decide(a, b, at, &meant).unwrap_or(Common::Open)
}

/// None where something cannot be shown.
fn decide(
    a: &Boundary,
    b: &Boundary,
    at: &Placement,
    meant: &dyn Fn(&[V; 3]) -> bool,
) -> Option<Common> {
    let reach = a.off() + b.off();
    let region = a.bounds().loosened(reach);
    let back = at.inverse();
    if !region.intersects(&turned(b.bounds(), at)) {
        return Some(Common::Nothing);
    }
    let seen = turned(&region, &back);
    let mut faces: BTreeMap<(u32, u32), Pair<'_>> = BTreeMap::new();
    let whole = &Placement::IDENTITY;
    for leaf in b.tree().leaves(|node| node.aabb().intersects(&seen)) {
        let (index_b, face_b, own) = b.triangle(leaf)?;
        let tri_b = own.map(|p| V::from(at.point(p.into())));
        let normal_b = unit_normal(&tri_b);
        if meant(&tri_b) {
            continue;
        }
        let around = aabb(&tri_b).loosened(reach);
        for other in a.tree().leaves(|node| node.aabb().intersects(&around)) {
            let (index_a, face_a, tri_a) = a.triangle(other)?;
            if meant(&tri_a) {
                continue;
            }
            let pair = faces.entry((index_a, index_b)).or_insert_with(|| {
                let (on_a, on_b) = (Patch::face(a, whole, face_a), Patch::face(b, at, face_b));
                let parted = outside(&on_a, &on_b) || outside(&on_b, &on_a);
                Pair {
                    on_a,
                    on_b,
                    indices: (index_a, index_b),
                    parted,
                    others: None,
                }
            });
            let same_way = unit_normal(&tri_a).dot(&normal_b) > SAME_WAY;
            if pair.parted && !same_way {
                continue;
            }
            if apart(&tri_a, &tri_b, face_a.off + face_b.off) {
                continue;
            }
            let others = pair.others();
            let parted = pair.parted || others.edgewise || pair.pieces_parted(&tri_a, &tri_b);
            if !parted || (same_way && !others.beside) {
                return None;
            }
        }
    }
    if inner_edges_meet(a, b, at) {
        return None;
    }
    let clear = some_outside(a, b, &back)? && some_outside(b, a, at)?;
    clear.then_some(Common::Nothing)
}

/// Two faces that come near each other.
struct Pair<'a> {
    on_a: Patch<'a>,
    on_b: Patch<'a>,
    indices: (u32, u32),
    /// All of one is on the outer side of the other.
    parted: bool,
    /// What else is known of them, once it was asked.
    others: Option<Others>,
}

/// Ways in which two faces may be parted that take longer to see.
#[derive(Debug, Clone, Copy)]
struct Others {
    /// They meet in the plane of a neighbour at most.
    edgewise: bool,
    /// They meet on the borders of both at most.
    beside: bool,
}

impl Pair<'_> {
    fn others(&mut self) -> Others {
        let (a, b, (index_a, index_b)) = (&self.on_a, &self.on_b, self.indices);
        *self.others.get_or_insert_with(|| {
            let plane = between(a, index_a, b).or_else(|| between(b, index_b, a));
            let on_borders =
                |p: super::edgewise::Between| p.meets_border_of(a) && p.meets_border_of(b);
            Others {
                edgewise: plane.is_some(),
                beside: plane.is_some_and(on_borders) || beside(a, b),
            }
        })
    }

    /// Whether the pieces that belong to two of their triangles are parted.
    fn pieces_parted(&self, tri_a: &[V; 3], tri_b: &[V; 3]) -> bool {
        let cut = |patch: &Patch<'_>| {
            matches!(patch.surface, Surface::Plane { .. })
                || matches!(patch.surface, Surface::Round { slope, .. } if slope == 0.0)
        };
        let (piece_a, piece_b) = (self.on_a.piece(*tri_a), self.on_b.piece(*tri_b));
        (cut(&self.on_b) && outside(&self.on_a, &piece_b))
            || (cut(&self.on_a) && outside(&self.on_b, &piece_a))
    }
}

fn unit_normal([p, q, r]: &[V; 3]) -> V {
    let normal = (q - p).cross(&(r - p));
    normal.try_normalize(1e-18).unwrap_or_default()
}

/// The box of a box's corners at another place.
pub(super) fn turned(bounds: &Aabb, at: &Placement) -> Aabb {
    let corners = bounds
        .vertices()
        .map(|v| V::from(at.point([v.x, v.y, v.z])));
    aabb(&corners)
}

/// Whether inner edges of both may lie on each other.
fn inner_edges_meet(a: &Boundary, b: &Boundary, at: &Placement) -> bool {
    let placed: Vec<Chain> = b
        .inner()
        .iter()
        .map(|chain| Chain {
            points: chain
                .points
                .iter()
                .map(|p| V::from(at.point((*p).into())))
                .collect(),
            off: chain.off,
        })
        .collect();
    a.inner().iter().any(|one| {
        let bounds = aabb(&one.points);
        placed.iter().any(|two| {
            let reach = one.off + two.off + 1e-6;
            bounds.loosened(reach).intersects(&aabb(&two.points)) && chains_meet(one, two, reach)
        })
    })
}

fn chains_meet(one: &Chain, two: &Chain, reach: f64) -> bool {
    let links = |chain: &Chain| -> Vec<(V, V)> {
        let next = chain.points.iter().skip(1);
        chain.points.iter().copied().zip(next.copied()).collect()
    };
    let others = links(two);
    links(one).iter().any(|(a0, a1)| {
        let mut pairs = others.iter();
        pairs.any(|(b0, b1)| between_segments(a0, a1, b0, b1).norm() <= reach)
    })
}

/// Whether every shell of a solid has a point outside of another one, which the placement puts its points
/// into the frame of; none where it cannot be told.
fn some_outside(of: &Boundary, other: &Boundary, at: &Placement) -> Option<bool> {
    // The middle of a triangle is that near to a point of the skin.
    let bounds = other.bounds().loosened(other.off() + of.off());
    let mut open: Vec<u32> = (0..of.shells()).collect();
    let center = |index: u32| {
        let (_, face, [p, q, r]) = of.triangle(index)?;
        Some((face.shell, V::from(at.point(((p + q + r) / 3.0).into()))))
    };
    // Most shells reach out of the other's box.
    for index in 0..of.count() {
        let (shell, point) = center(index)?;
        if open.contains(&shell) && !bounds.contains_local_point(super::boundary::real3(&point)) {
            open.retain(|s| *s != shell);
            if open.is_empty() {
                return Some(true);
            }
        }
    }
    for shell in open {
        let told = (0..of.count()).find_map(|index| {
            let (own, point) = center(index)?;
            (own == shell)
                .then(|| contains(other, &point, of.off()))
                .flatten()
        });
        if told? {
            return Some(false);
        }
    }
    Some(true)
}
