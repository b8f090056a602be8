//! Triangles.

use core::f64::consts::PI;
use std::collections::BTreeMap;

use assemcad_kernel::Shape;
use assemcad_kernel::facts::Turn;
use assemcad_kernel::mesh::Mesh;
use assemcad_kernel::section::{behind, shared};
use assemcad_model::frame::{Frame, Placement};

use super::common::{Two, cuboid, cylinder, near, slanted};

fn minus(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// By the divergence theorem: a sixth of the sum of the triangles' triple products.
fn volume(mesh: &Mesh) -> f64 {
    let corner = |i: u32| mesh.positions[i as usize];
    let six: f64 = mesh
        .triangles
        .iter()
        .map(|[a, b, c]| dot(corner(*a), cross(corner(*b), corner(*c))))
        .sum();
    six / 6.0
}

#[test]
fn the_volume_of_the_triangles_converges() {
    let tube = cylinder([3.0, 4.0, 5.0], 10.0, 8.0).cut(&cylinder([3.0, 4.0, 0.0], 6.0, 20.0));

    let exact = 64.0 * PI * 8.0;
    let mut last = f64::INFINITY;
    for (deflection, within) in [(0.5, 0.1), (0.05, 0.01), (0.005, 0.001)] {
        let off = (volume(&tube.mesh(deflection, 30.0).unwrap()) - exact).abs() / exact;
        assert!(off < within && off < last, "{off} at {deflection}");
        last = off;
    }
}

#[test]
fn normals_agree_with_the_triangles() {
    let solid = cuboid([0.0; 3], [10.0; 3]).cut(&cylinder([5.0, 5.0, -1.0], 2.0, 12.0));
    let mesh = solid.mesh(0.01, 10.0).unwrap();
    assert_eq!(mesh.positions.len(), mesh.normals.len());
    near(volume(&mesh), 1000.0 - 40.0 * PI, 1e-3);
    for [a, b, c] in &mesh.triangles {
        let [p, q, r] = [a, b, c].map(|i| mesh.positions[*i as usize]);
        let flat = cross(minus(q, p), minus(r, p));
        for i in [a, b, c] {
            let n = mesh.normals[*i as usize];
            near(dot(n, n), 1.0, 1e-9);
            assert!(dot(flat, n) > 0.9 * dot(flat, flat).sqrt());
        }
    }
    assert_eq!(solid.mesh(0.01, 10.0).unwrap(), mesh);
    assert!(solid.mesh(0.0, 10.0).is_err());
    assert!(solid.mesh(0.1, 0.0).is_err());
}

/// A plate of 40 x 30 x 5 mm with two holes of 3 mm radius through it.
fn drilled() -> Shape {
    cuboid([0.0; 3], [40.0, 30.0, 5.0])
        .cut(&cylinder([10.0, 15.0, -1.0], 3.0, 7.0))
        .cut(&cylinder([30.0, 15.0, -1.0], 3.0, 7.0))
}

/// How often each way along each edge of the triangles is gone; nodes in one place are one.
fn ways(mesh: &Mesh) -> BTreeMap<([i64; 3], [i64; 3]), usize> {
    let place = |i: u32| mesh.positions[i as usize].map(|x| (x * 1e7).round() as i64);
    let mut ways = BTreeMap::new();
    for [a, b, c] in &mesh.triangles {
        let [a, b, c] = [a, b, c].map(|i| place(*i));
        // A triangle without area, as at a pole, has no edges of its own.
        if a == b || b == c || c == a {
            continue;
        }
        for way in [(a, b), (b, c), (c, a)] {
            *ways.entry(way).or_insert(0) += 1;
        }
    }
    ways
}

#[test]
fn meshes_are_watertight() {
    let leaning = Shape::cylinder(&slanted(), 4.0, 9.0).unwrap();
    let ball = Shape::sphere(&slanted(), 6.0).unwrap();
    for (name, solid) in [
        ("box", cuboid([1.0, 2.0, 3.0], [4.0, 5.0, 6.0])),
        ("cylinder", leaning),
        ("sphere", ball),
        ("plate", drilled()),
    ] {
        for deflection in [1.0, 0.01] {
            let ways = ways(&solid.mesh(deflection, 20.0).unwrap());
            assert!(ways.len() >= 18, "{name}");
            for ((a, b), count) in &ways {
                // Each edge belongs to two triangles, which run along it in opposite ways.
                assert_eq!(
                    (*count, ways.get(&(*b, *a))),
                    (1, Some(&1)),
                    "{name} {deflection}"
                );
            }
        }
    }
}

#[test]
fn volumes_converge_to_the_closed_forms() {
    for (solid, exact) in [
        (cuboid([1.0, 2.0, 3.0], [4.0, 5.0, 6.0]), 120.0),
        (Shape::cylinder(&slanted(), 4.0, 9.0).unwrap(), 144.0 * PI),
        (Shape::sphere(&slanted(), 6.0).unwrap(), 288.0 * PI),
        (drilled(), 6000.0 - 90.0 * PI),
    ] {
        let off = |deflection: f64| {
            (volume(&solid.mesh(deflection, 30.0).unwrap()) - exact).abs() / exact
        };
        let (coarse, fine) = (off(0.1), off(0.001));
        assert!(
            coarse < 0.05 && fine < 6e-4 && fine <= coarse + 1e-12,
            "{exact}: {coarse} {fine}"
        );
    }
}

#[test]
fn edges_run_along_the_triangles() {
    let mesh = drilled().mesh(0.01, 20.0).unwrap();
    let nodes: Vec<[f64; 3]> = mesh.positions.clone();
    // 12 edges of the box, 2 circles for each hole, 1 seam for each hole.
    let count = |turn| mesh.lines.iter().filter(|l| l.turn == turn).count();
    assert_eq!(
        (count(Turn::Convex), count(Turn::Seam), mesh.lines.len()),
        (16, 2, 18)
    );
    let mut length = 0.0;
    for line in &mesh.lines {
        assert!(line.points.len() >= 2);
        for point in &line.points {
            assert!(nodes.contains(point), "{point:?}");
        }
        if line.turn == Turn::Convex {
            for pair in line.points.windows(2) {
                let d = minus(pair[1], pair[0]);
                length += dot(d, d).sqrt();
            }
        }
    }
    near(length, 4.0 * (40.0 + 30.0 + 5.0) + 4.0 * 6.0 * PI, 0.1);
    assert_eq!(drilled().edges().unwrap().len(), 18);
}

#[test]
fn a_mesh_comes_back_from_its_bytes() {
    let mesh = drilled().mesh(0.1, 20.0).unwrap();
    let bytes = mesh.to_bytes().unwrap();
    assert_eq!(Mesh::from_bytes(&bytes), Some(mesh));
    for end in [0, 11, 12, bytes.len() / 2, bytes.len() - 1] {
        assert_eq!(Mesh::from_bytes(&bytes[..end]), None, "{end}");
    }
    // A triangle that names a node beyond the last one.
    let mut bytes = bytes;
    bytes[..4].copy_from_slice(&1_u32.to_le_bytes());
    assert_eq!(Mesh::from_bytes(&bytes), None);
}

#[test]
fn a_plane_leaves_what_is_behind_it() {
    let cut = |solid: &Shape, point, normal| {
        behind(solid, point, normal).unwrap().map(|s| {
            (
                s.mass().unwrap().volume,
                volume(&s.mesh(0.01, 10.0).unwrap()),
            )
        })
    };
    let block = cuboid([0.0; 3], [10.0, 20.0, 30.0]);
    let (exact, meshed) = cut(&block, [0.0, 0.0, 12.0], [0.0, 0.0, 1.0]).unwrap();
    near(exact, 10.0 * 20.0 * 12.0, 1e-6);
    near(meshed, exact, 1e-6);
    // The other side of the same plane.
    near(
        cut(&block, [0.0, 0.0, 12.0], [0.0, 0.0, -1.0]).unwrap().0,
        200.0 * 18.0,
        1e-6,
    );
    // Across a corner: the plane x + y + z = 9 leaves the corner's tetrahedron.
    near(
        cut(&block, [9.0, 0.0, 0.0], [1.0; 3]).unwrap().0,
        9.0_f64.powi(3) / 6.0,
        1e-6,
    );
    // Half a ball, closed by its disc.
    let ball = Shape::sphere(&Frame::WORLD, 6.0).unwrap();
    let (exact, meshed) = cut(&ball, [0.0; 3], [0.0, 1.0, 0.0]).unwrap();
    near(exact, 144.0 * PI, 1e-6);
    near(meshed / exact, 1.0, 5e-3);
    // A plane beside the solid, and one in its face.
    near(
        cut(&block, [0.0, 0.0, 31.0], [0.0, 0.0, 1.0]).unwrap().0,
        6000.0,
        1e-6,
    );
    near(
        cut(&block, [0.0, 0.0, 30.0], [0.0, 0.0, 1.0]).unwrap().0,
        6000.0,
        1e-6,
    );
    assert!(cut(&block, [0.0; 3], [0.0, 0.0, 1.0]).is_none());
    assert!(behind(&block, [0.0; 3], [0.0; 3]).is_err());
}

#[test]
fn the_common_part_is_a_solid_of_its_own() {
    let block = cuboid([0.0; 3], [10.0; 3]);
    let at = |x| Placement::translation(x, 2.0, 3.0);
    let both = |x| shared(&block, &Placement::IDENTITY, &block, &at(x)).unwrap();
    let common = both(6.0).unwrap();
    near(common.mass().unwrap().volume, 4.0 * 8.0 * 7.0, 1e-9);
    near(volume(&common.mesh(0.1, 20.0).unwrap()), 224.0, 1e-9);
    assert!(both(10.0).is_none(), "they touch");
    assert!(both(11.0).is_none(), "they are apart");
}
