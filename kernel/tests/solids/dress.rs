//! Fillets and chamfers, and the edges that selectors mean.

use core::f64::consts::PI;

use assemcad_kernel::Shape;
use assemcad_kernel::facts::Turn;
use assemcad_kernel::select::select;
use assemcad_model::recipe::EdgeSelector;

use super::common::{cuboid, cylinder, near, says, volume};

fn parallel(direction: [f64; 3]) -> EdgeSelector {
    EdgeSelector::Parallel { direction }
}

fn in_plane(point: [f64; 3], normal: [f64; 3]) -> EdgeSelector {
    EdgeSelector::InPlane { point, normal }
}

fn pick(shape: &Shape, selector: &EdgeSelector) -> Vec<u32> {
    select(selector, &shape.edges().unwrap()).unwrap()
}

#[test]
fn one_rounded_edge_loses_its_corner() {
    let (r, l) = (2.0_f64, 30.0);
    let b = cuboid([0.0; 3], [10.0, 20.0, l]);
    let one = pick(&b, &parallel([0.0, 0.0, -3.0]));
    assert_eq!(one.len(), 4);
    let loss = (1.0 - PI / 4.0) * r * r * l;
    near(
        volume(&b.fillet(&one[..1], r).unwrap()),
        6000.0 - loss,
        1e-10,
    );
    near(
        volume(&b.fillet(&one, r).unwrap()),
        6000.0 - 4.0 * loss,
        1e-10,
    );
}

#[test]
fn one_bevelled_edge_loses_its_corner() {
    let (d, l) = (2.0_f64, 30.0);
    let b = cuboid([0.0; 3], [10.0, 20.0, l]);
    let edges = pick(&b, &parallel([0.0, 0.0, 1.0]));
    near(
        volume(&b.chamfer(&edges[..1], d).unwrap()),
        6000.0 - d * d / 2.0 * l,
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
    let all = pick(&b, &EdgeSelector::All);
    assert_eq!(all.len(), 12);
    let rounded = b.fillet(&all, r).unwrap();
    near(volume(&rounded), expected, 1e-9);
    // What is round already has no edge left to round.
    let error = select(&EdgeSelector::All, &rounded.edges().unwrap()).unwrap_err();
    says(&error, &["no edge"]);
}

#[test]
fn inner_edges_gain_material() {
    let b = cuboid([0.0; 3], [10.0; 3])
        .fuse(&cuboid([0.0; 3], [20.0, 10.0, 4.0]))
        .unwrap();
    let edges = b.edges().unwrap();
    let inner: Vec<u32> = edges
        .iter()
        .zip(0..)
        .filter(|(e, _)| e.turn == Turn::Concave)
        .map(|(_, i)| i)
        .collect();
    assert_eq!(inner.len(), 1);
    let gain = (1.0 - PI / 4.0) * 4.0 * 10.0;
    near(
        volume(&b.fillet(&inner, 2.0).unwrap()),
        1400.0 + gain,
        1e-10,
    );
    near(
        volume(&b.chamfer(&inner, 2.0).unwrap()),
        1400.0 + 20.0,
        1e-12,
    );
}

#[test]
fn a_rim_is_bevelled_by_pappus() {
    let (r, d) = (5.0_f64, 1.0_f64);
    let c = cylinder([0.0; 3], r, 10.0);
    // Neither the seam nor the other rim.
    let top = pick(&c, &in_plane([3.0, 4.0, 10.0], [0.0, 0.0, 2.0]));
    assert_eq!(top.len(), 1);
    assert_eq!(pick(&c, &EdgeSelector::All).len(), 2);
    // The removed triangle's centroid is d/3 from the wall.
    let loss = d * d / 2.0 * 2.0 * PI * (r - d / 3.0);
    near(
        volume(&c.chamfer(&top, d).unwrap()),
        250.0 * PI - loss,
        1e-11,
    );
    // The removed corner's area is (1 - pi/4) d2; what stays of the square is a quarter disc.
    let quarter = PI / 4.0 * d * d * 2.0 * PI * (r - d + 4.0 * d / (3.0 * PI));
    let square = d * d * 2.0 * PI * (r - d / 2.0);
    near(
        volume(&c.fillet(&top, d).unwrap()),
        250.0 * PI - square + quarter,
        1e-10,
    );
}

#[test]
fn what_does_not_fit_is_an_error_and_no_crash() {
    let cube = cuboid([0.0; 3], [10.0; 3]);
    let all = pick(&cube, &EdgeSelector::All);
    for radius in [5.0, 6.0, 20.0] {
        let error = cube.fillet(&all, radius).unwrap_err();
        says(
            &error,
            &[
                &format!("the fillet of {radius} mm"),
                "the 12 selected edges: ",
            ],
        );
    }
    for distance in [5.0, 6.0, 20.0] {
        says(
            &cube.chamfer(&all, distance).unwrap_err(),
            &["the chamfer of"],
        );
    }
    says(
        &cube.fillet(&[], 1.0).unwrap_err(),
        &["no edge is selected"],
    );
    says(
        &cube.fillet(&[12], 1.0).unwrap_err(),
        &["there is no edge 12"],
    );
    says(
        &cube.fillet(&all, 0.0).unwrap_err(),
        &["fillet's radius is 0 mm"],
    );
    let c = cylinder([0.0; 3], 5.0, 10.0);
    let edges = c.edges().unwrap();
    let seam = u32::try_from(edges.iter().position(|e| e.turn == Turn::Seam).unwrap()).unwrap();
    says(
        &c.fillet(&[seam], 1.0).unwrap_err(),
        &["do not meet at an angle"],
    );
}

#[test]
fn selectors_that_mean_nothing_are_refused() {
    let edges = cuboid([0.0; 3], [10.0; 3]).edges().unwrap();
    says(
        &select(&parallel([1.0, 1.0, 0.0]), &edges).unwrap_err(),
        &["no straight edge"],
    );
    says(
        &select(&parallel([0.0; 3]), &edges).unwrap_err(),
        &["has no length"],
    );
    let nowhere = in_plane([0.0, 0.0, 5.0], [0.0, 0.0, 1.0]);
    says(
        &select(&nowhere, &edges).unwrap_err(),
        &["no edge of the solid lies in the plane"],
    );
    assert_eq!(
        select(&in_plane([0.0; 3], [0.0, 0.0, 1.0]), &edges)
            .unwrap()
            .len(),
        4
    );
}
