//! Triangles.

use core::f64::consts::PI;

use assemcad_kernel::mesh::Mesh;

use super::common::{Two, cuboid, cylinder, near};

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
