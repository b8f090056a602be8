//! Fillets and chamfers of whole cubes, inner edges and rims.

use core::f64::consts::PI;

use assemcad_kernel::Shape;

use super::common::{Two, cuboid, cylinder, edges_where, near, one, says, volume};

fn rounded(solid: &Shape, edges: &[Shape], radius: f64) -> f64 {
    let all: Vec<&Shape> = edges.iter().collect();
    volume(&one(&solid.filleted(&all, radius).unwrap()))
}

fn bevelled(solid: &Shape, edges: &[Shape], length: f64) -> f64 {
    let all: Vec<&Shape> = edges.iter().collect();
    volume(&one(&solid.chamfered(&all, length, None).unwrap()))
}

#[test]
fn one_edge_loses_its_corner() {
    let (r, l) = (2.0_f64, 30.0);
    let b = cuboid([0.0; 3], [10.0, 20.0, l]);
    let upright = edges_where(&b, |[_, _, z]| (z - 15.0).abs() < 1e-9);
    assert_eq!(upright.len(), 4);
    let loss = (1.0 - PI / 4.0) * r * r * l;
    near(rounded(&b, &upright[..1], r), 6000.0 - loss, 1e-10);
    near(
        bevelled(&b, &upright[..1], r),
        6000.0 - r * r / 2.0 * l,
        1e-12,
    );
}

#[test]
fn every_edge_of_a_cube_rounded() {
    // A cube of side a - 2r, grown by r: faces, quarter cylinders and a ball.
    let (a, r) = (10.0_f64, 2.0_f64);
    let core = a - 2.0 * r;
    let expected =
        core.powi(3) + 6.0 * core * core * r + 3.0 * PI * r * r * core + 4.0 / 3.0 * PI * r.powi(3);
    let b = cuboid([0.0; 3], [a; 3]);
    let all = edges_where(&b, |_| true);
    assert_eq!(all.len(), 12);
    near(rounded(&b, &all, r), expected, 1e-9);
}

#[test]
fn inner_edges_gain_material() {
    let b = cuboid([0.0; 3], [10.0; 3]).fuse(&cuboid([0.0; 3], [20.0, 10.0, 4.0]));
    let inner = edges_where(&b, |[x, y, z]| {
        (x - 10.0).abs() < 1e-9 && (y - 5.0).abs() < 1e-9 && (z - 4.0).abs() < 1e-9
    });
    assert_eq!(inner.len(), 1);
    let gain = (1.0 - PI / 4.0) * 4.0 * 10.0;
    near(rounded(&b, &inner, 2.0), 1400.0 + gain, 1e-10);
    near(bevelled(&b, &inner, 2.0), 1400.0 + 20.0, 1e-12);
}

#[test]
fn a_rim_is_bevelled_by_pappus() {
    let (r, d) = (5.0_f64, 1.0_f64);
    let c = cylinder([0.0; 3], r, 10.0);
    // Neither the seam nor the other rim.
    let top = edges_where(&c, |[_, _, z]| (z - 10.0).abs() < 1e-9);
    assert_eq!(top.len(), 1);
    // The removed triangle's centroid is d/3 from the wall.
    let loss = d * d / 2.0 * 2.0 * PI * (r - d / 3.0);
    near(bevelled(&c, &top, d), 250.0 * PI - loss, 1e-11);
    // The removed corner's area is (1 - pi/4) d2; what stays of the square is a quarter disc.
    let quarter = PI / 4.0 * d * d * 2.0 * PI * (r - d + 4.0 * d / (3.0 * PI));
    let square = d * d * 2.0 * PI * (r - d / 2.0);
    near(rounded(&c, &top, d), 250.0 * PI - square + quarter, 1e-10);
}

#[test]
fn what_does_not_fit_is_an_error_and_no_crash() {
    let cube = cuboid([0.0; 3], [10.0; 3]);
    let edges = edges_where(&cube, |_| true);
    let all: Vec<&Shape> = edges.iter().collect();
    // Between 5 and 20 the kernel makes a broken solid: the interpreter refuses it.
    for size in [5.0, 20.0] {
        says(
            &cube.filleted(&all, size).unwrap_err(),
            &[&format!("the fillet of {size} mm")],
        );
        says(
            &cube.chamfered(&all, size, None).unwrap_err(),
            &[&format!("the chamfer of {size} mm")],
        );
    }
    says(
        &cube.filleted(&all, 0.0).unwrap_err(),
        &["fillet's radius is 0 mm"],
    );
    let pin = cylinder([0.0; 3], 5.0, 10.0);
    let seam = edges_where(&pin, |[_, _, z]| (z - 5.0).abs() < 1e-9);
    assert_eq!(seam.len(), 1);
    assert!(pin.filleted(&[&seam[0]], 1.0).is_err());
}
