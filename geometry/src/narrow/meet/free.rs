//! Surfaces that have no closed form here: tooth flanks, grooves, springs, crossing cylinders. They meet where
//! their triangles do.

use std::collections::BTreeMap;

use assemcad_model::frame::Placement;

use super::{Kind, Meeting, Spot, spot};
use crate::narrow::boundary::Boundary;
use crate::narrow::patch::{Patch, V};
use crate::narrow::triangles::on_triangle;

/// Across more than this nothing is stopped, in mm. Ours.
const REACH_MM: f64 = 0.3;

/// Triangles whose normals are this much against each other, as a cosine, may hold each other.
const AGAINST: f64 = -0.8;

/// Where the triangles of two faces meet, from pairs of them that may be near.
pub(super) fn meet(
    (a, on_a): (&Boundary, &Patch<'_>),
    (b, on_b, at): (&Boundary, &Patch<'_>, &Placement),
    near: &[(u32, u32)],
) -> Option<Meeting> {
    let most = REACH_MM + on_a.face.off + on_b.face.off;
    let mut by_way: BTreeMap<[i8; 3], [Spot; 2]> = BTreeMap::new();
    let mut least = f64::INFINITY;
    for (one, two) in near {
        let (Some((.., tri_a)), Some((.., own))) = (a.triangle(*one), b.triangle(*two)) else {
            continue;
        };
        let tri_b = own.map(|p| V::from(at.point(p.into())));
        let (Some(up_a), Some(up_b)) = (normal(&tri_a), normal(&tri_b)) else {
            continue;
        };
        if up_a.dot(&up_b) > AGAINST {
            continue;
        }
        let middle = |t: &[V; 3]| (t[0] + t[1] + t[2]) / 3.0;
        let (from_a, from_b) = (middle(&tri_a), middle(&tri_b));
        for (p, q) in [
            (from_a, on_triangle(&from_a, &tri_b)),
            (on_triangle(&from_b, &tri_a), from_b),
        ] {
            let way = q - p;
            let gap = way.dot(&up_a);
            // Beside each other rather than before each other.
            if way.norm() > most || (way - up_a * gap).norm() > 0.5 * most {
                continue;
            }
            least = least.min(gap);
            let found = spot(p, up_a, gap);
            let sector = <[f64; 3]>::from(up_a).map(|x| libm::round(2.0 * x) as i8);
            let [nearest, farthest] = by_way.entry(sector).or_insert([found; 2]);
            let away = |s: &Spot| (V::from(s.at) - V::from(nearest.at)).norm();
            if away(&found) > away(farthest) {
                *farthest = found;
            }
            if gap < nearest.gap_mm {
                *nearest = found;
            }
        }
    }
    let mut spots: Vec<Spot> = by_way.into_values().flatten().collect();
    spots.dedup();
    (!spots.is_empty()).then_some(Meeting {
        kind: Kind::Free,
        gap_mm: (least - on_a.face.off - on_b.face.off).max(0.0),
        area_mm2: 0.0,
        about: None,
        spots,
    })
}

fn normal([p, q, r]: &[V; 3]) -> Option<V> {
    (q - p).cross(&(r - p)).try_normalize(1e-18)
}
