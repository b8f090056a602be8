//! A solid's skin, made ready to be held against others.

use assemcad_kernel::facts::Turn;
use assemcad_kernel::skin::{Skin, SkinCurve, SkinEdge, SkinFace, SkinSurface};
use parry3d_f64::bounding_volume::{Aabb, BoundingVolume};
use parry3d_f64::math::Vector as Real3;
use parry3d_f64::partitioning::{Bvh, BvhBuildStrategy};

use super::patch::V;

/// How far apart the points are that stand for a round inner edge, in radians.
const STEP: f64 = 0.1;

/// A solid's skin with a tree of its triangles and what else is asked of it again and again.
#[derive(Debug)]
pub struct Boundary {
    skin: Skin,
    /// The face of each triangle.
    face_of: Vec<u32>,
    /// Over the triangles, in their order.
    tree: Bvh,
    bounds: Aabb,
    /// The largest distance between triangles and faces, in mm.
    off: f64,
    /// By how much pieces of each face may reach beyond their triangles along the surface, in mm.
    bulges: Vec<f64>,
    /// The inner edges, as chains of points and how far the edge may be off the chain.
    inner: Vec<Chain>,
    shells: u32,
    /// The two faces of each edge that has two.
    sides: Vec<Option<[u32; 2]>>,
}

/// An inner edge.
#[derive(Debug)]
pub(super) struct Chain {
    pub(super) points: Vec<V>,
    pub(super) off: f64,
}

pub(super) fn real3(v: &V) -> Real3 {
    Real3::new(v.x, v.y, v.z)
}

impl Boundary {
    /// From a skin; none where its numbers do not fit each other.
    #[must_use]
    pub fn new(skin: Skin) -> Option<Self> {
        let mut face_of = vec![u32::MAX; skin.triangles.len()];
        for (index, face) in skin.faces.iter().enumerate() {
            let [from, to] = face.triangles.map(|n| n as usize);
            let own = face_of.get_mut(from..to)?;
            own.fill(u32::try_from(index).ok()?);
            if face.edges.iter().any(|e| *e as usize >= skin.edges.len()) {
                return None;
            }
        }
        let corners = |t: &[u32; 3]| -> Option<[V; 3]> {
            let [a, b, c] = t.map(|n| skin.positions.get(n as usize).copied().map(V::from));
            Some([a?, b?, c?])
        };
        let mut boxes = Vec::with_capacity(skin.triangles.len());
        for triangle in &skin.triangles {
            boxes.push(aabb(&corners(triangle)?));
        }
        if boxes.is_empty() || face_of.contains(&u32::MAX) {
            return None;
        }
        let tree = Bvh::from_leaves(BvhBuildStrategy::Binned, &boxes);
        let off = skin.faces.iter().map(|f| f.off).fold(0.0, f64::max);
        let bounds = tree.root_aabb();
        let bulges = skin.faces.iter().map(|f| bulge(&skin, f)).collect();
        let inner = skin.edges.iter().filter_map(inner).collect();
        let sides = sides(&skin);
        let shells = skin.faces.iter().map(|f| f.shell + 1).max().unwrap_or(0);
        Some(Self {
            skin,
            face_of,
            tree,
            bounds,
            off,
            bulges,
            inner,
            shells,
            sides,
        })
    }

    /// The skin.
    #[must_use]
    pub fn skin(&self) -> &Skin {
        &self.skin
    }

    /// About how many bytes it takes.
    #[must_use]
    pub fn bytes(&self) -> usize {
        let skin = &self.skin;
        let points = (skin.positions.len() + skin.triangles.len()) * 24;
        points
            + self.tree.total_memory_size()
            + skin.faces.len() * 200
            + skin.edges.len() * 170
            + self.face_of.len() * 4
    }

    pub(super) fn edge(&self, index: u32) -> Option<&SkinEdge> {
        self.skin.edges.get(index as usize)
    }

    /// The plane faces that a face meets in outer edges, each once.
    pub(super) fn flat_neighbours(&self, face: u32) -> Vec<&SkinFace> {
        let own = self.skin.faces.get(face as usize);
        let edges = own.into_iter().flat_map(|f| &f.edges);
        let mut found: Vec<u32> = edges
            .filter(|e| self.edge(**e).is_some_and(|e| e.turn == Turn::Convex))
            .filter_map(|e| *self.sides.get(*e as usize)?)
            .map(|[one, two]| if one == face { two } else { one })
            .collect();
        found.sort_unstable();
        found.dedup();
        let faces = found.into_iter();
        faces
            .filter_map(|f| self.skin.faces.get(f as usize))
            .filter(|f| matches!(f.surface, SkinSurface::Plane { .. }))
            .collect()
    }

    pub(super) fn tree(&self) -> &Bvh {
        &self.tree
    }

    /// The box of the triangles.
    pub(super) fn bounds(&self) -> &Aabb {
        &self.bounds
    }

    pub(super) fn off(&self) -> f64 {
        self.off
    }

    pub(super) fn inner(&self) -> &[Chain] {
        &self.inner
    }

    pub(super) fn shells(&self) -> u32 {
        self.shells
    }

    pub(super) fn bulge(&self, face: &SkinFace) -> f64 {
        let index = self.face_of.get(face.triangles[0] as usize);
        index
            .and_then(|i| self.bulges.get(*i as usize))
            .copied()
            .unwrap_or(face.off)
    }

    /// A triangle's face and corners.
    pub(super) fn triangle(&self, index: u32) -> Option<(u32, &SkinFace, [V; 3])> {
        let face = *self.face_of.get(index as usize)?;
        let corners = self.corners(self.skin.triangles.get(index as usize)?)?;
        Some((face, self.skin.faces.get(face as usize)?, corners))
    }

    /// The triangles whose boxes come nearer to a point than `reach`, and their faces.
    pub(super) fn triangles_near(
        &self,
        point: &V,
        reach: f64,
    ) -> impl Iterator<Item = (&SkinFace, [V; 3])> {
        let around = aabb(&[*point]).loosened(reach);
        let leaves = self
            .tree
            .leaves(move |node| node.aabb().intersects(&around));
        leaves.filter_map(|leaf| {
            let (_, face, corners) = self.triangle(leaf)?;
            Some((face, corners))
        })
    }

    pub(super) fn count(&self) -> u32 {
        u32::try_from(self.skin.triangles.len()).unwrap_or(u32::MAX)
    }

    fn corners(&self, triangle: &[u32; 3]) -> Option<[V; 3]> {
        let [a, b, c] = triangle.map(|n| self.skin.positions.get(n as usize).copied().map(V::from));
        Some([a?, b?, c?])
    }
}

/// The box of some points.
pub(super) fn aabb(points: &[V]) -> Aabb {
    let (mut lo, mut hi) = (Real3::splat(f64::INFINITY), Real3::splat(f64::NEG_INFINITY));
    for p in points {
        lo = lo.min(real3(p));
        hi = hi.max(real3(p));
    }
    Aabb::new(lo, hi)
}

/// By how much pieces of a face may reach beyond their triangles along the surface: where straight lines and,
/// on cylinders and cones, circles bound it, by nothing.
fn bulge(skin: &Skin, face: &SkinFace) -> f64 {
    let round = matches!(
        face.surface,
        SkinSurface::Cylinder { .. } | SkinSurface::Cone { .. }
    );
    let exact = |curve: &SkinCurve| match curve {
        SkinCurve::Line | SkinCurve::Point => true,
        SkinCurve::Circle { .. } => round,
        SkinCurve::Other => false,
    };
    let mut edges = face
        .edges
        .iter()
        .filter_map(|e| skin.edges.get(*e as usize));
    match edges.all(|e| exact(&e.curve)) {
        true => 0.0,
        false => face.off,
    }
}

/// The faces of the edges.
fn sides(skin: &Skin) -> Vec<Option<[u32; 2]>> {
    let mut found: Vec<Vec<u32>> = vec![Vec::new(); skin.edges.len()];
    for (index, face) in (0_u32..).zip(&skin.faces) {
        for edge in &face.edges {
            if let Some(of) = found.get_mut(*edge as usize) {
                of.push(index);
            }
        }
    }
    let two = |faces: Vec<u32>| <[u32; 2]>::try_from(faces).ok().filter(|[a, b]| a != b);
    found.into_iter().map(two).collect()
}

/// The chain of an inner edge; none of another one.
fn inner(edge: &SkinEdge) -> Option<Chain> {
    if edge.turn != Turn::Concave {
        return None;
    }
    let [start, middle, end] = [edge.start, edge.middle, edge.end].map(V::from);
    match edge.curve {
        SkinCurve::Line | SkinCurve::Point => Some(Chain {
            points: vec![start, end],
            off: 0.0,
        }),
        SkinCurve::Circle {
            center,
            axis,
            radius,
            sweep,
        } => {
            let (center, axis) = (V::from(center), V::from(axis));
            let first = start - center;
            let second = axis.cross(&first);
            let links = libm::ceil(sweep / STEP).max(1.0);
            let points = (0..=(links as u32)).map(|n| {
                let (sin, cos) = libm::sincos(sweep * f64::from(n) / links);
                center + first * cos + second * sin
            });
            Some(Chain {
                points: points.collect(),
                off: radius * (1.0 - libm::cos(sweep / links / 2.0)),
            })
        }
        // How far it strays from its chords is not known: as far as they are long.
        SkinCurve::Other => Some(Chain {
            off: (middle - start).norm().max((end - middle).norm()),
            points: vec![start, middle, end],
        }),
    }
}
