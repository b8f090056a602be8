//! Volume, area, centre and inertia against closed forms and against sums made here.
#![allow(
    clippy::unwrap_used,
    clippy::indexing_slicing,
    clippy::print_stdout,
    clippy::disallowed_methods,
    reason = "helpers of tests, outside of #[test] functions; no bits have to be equal elsewhere"
)]

use core::f64::consts::{PI, TAU};
use std::time::Instant;

use assemcad_kernel::Shape;
use assemcad_kernel::brep::{Corner, Spline, Topology};
use assemcad_kernel::query::Mass;
use assemcad_model::frame::{Frame, Placement};

const HERE: Placement = Placement::IDENTITY;

/// Nothing about it is round, and it is far off.
fn slanted() -> Placement {
    Placement::translation(400.0, -500.0, 600.0)
        .then_inner(&Placement::rotation_about([1.0, 2.0, 3.0], [1.0, -2.0, 0.5], 37.0).unwrap())
}

#[track_caller]
fn near(found: f64, expected: f64, relative: f64) {
    assert!(
        (found - expected).abs() <= relative * expected.abs(),
        "found {found}, expected {expected}, off by {:e}",
        (found - expected) / expected
    );
}

#[track_caller]
fn near3(found: [f64; 3], expected: [f64; 3]) {
    for (f, e) in found.iter().zip(expected) {
        assert!((f - e).abs() <= 1e-10, "{found:?} for {expected:?}");
    }
}

fn mass(shape: &Shape) -> Mass {
    shape.mass().unwrap()
}

#[track_caller]
fn is(shape: &Shape, volume: f64, area: f64) {
    let m = mass(shape);
    near(m.volume, volume, 1e-11);
    near(m.area, area, 1e-11);
}

/// Its volume, area, centre and inertia per volume along its axes; here and at a slanted place.
#[track_caller]
fn weighs(shape: &Shape, volume: f64, area: f64, center: [f64; 3], per_volume: [f64; 3]) {
    for at in [HERE, slanted()] {
        let placed = shape.moved(&at).unwrap();
        is(&placed, volume, area);
        let m = mass(&placed);
        near3(m.center, at.point(center));
        let axes = at.axes();
        for i in 0..3 {
            for j in 0..3 {
                let expected: f64 = (0..3)
                    .map(|k| volume * per_volume[k] * axes[k][i] * axes[k][j])
                    .sum();
                let largest = volume * per_volume.iter().copied().fold(0.0, f64::max);
                assert!(
                    (m.inertia[i][j] - expected).abs() <= 1e-11 * largest,
                    "{:?}, {i} {j}: {expected}",
                    m.inertia
                );
            }
        }
    }
}

fn face(edges: &[Shape]) -> Shape {
    let edges: Vec<&Shape> = edges.iter().collect();
    Shape::face(&Shape::wire(&edges).unwrap(), &[]).unwrap()
}

fn prism(edges: &[Shape], height: f64) -> Shape {
    face(edges).extruded([0.0, 0.0, height], 0.0).unwrap()
}

fn cuboid(size: [f64; 3]) -> Shape {
    Shape::cuboid(&Frame::WORLD, size).unwrap()
}

/// What a smooth periodic function sums to over a full turn: the trapezoidal rule, which errs
/// exponentially little.
fn around(f: impl Fn(f64) -> f64) -> f64 {
    const STEPS: u32 = 4000;
    (0..STEPS)
        .map(|k| f(f64::from(k) * TAU / f64::from(STEPS)))
        .sum::<f64>()
        * TAU
        / f64::from(STEPS)
}

#[test]
fn a_box() {
    let [a, b, c] = [4.0, 5.0, 6.0];
    let per = |p: f64, q: f64| (p * p + q * q) / 12.0;
    weighs(
        &cuboid([a, b, c]),
        a * b * c,
        2.0 * (a * b + b * c + c * a),
        [a / 2.0, b / 2.0, c / 2.0],
        [per(b, c), per(c, a), per(a, b)],
    );
}

#[test]
fn a_cylinder_and_a_part_of_one() {
    let (r, h) = (3.0, 7.0);
    let across = (3.0 * r * r + h * h) / 12.0;
    weighs(
        &Shape::cylinder_part(&HERE, r, h, 360.0).unwrap(),
        PI * r * r * h,
        TAU * r * (r + h),
        [0.0, 0.0, h / 2.0],
        [across, across, r * r / 2.0],
    );
    let part = Shape::cylinder_part(&HERE, r, h, 90.0).unwrap();
    is(
        &part,
        PI * r * r * h / 4.0,
        PI * r * r / 2.0 + PI * r * h / 2.0 + 2.0 * r * h,
    );
    let middle = 4.0 * r / (3.0 * PI);
    near3(mass(&part).center, [middle, middle, h / 2.0]);
}

#[test]
fn a_cone_and_a_frustum() {
    let (r, h) = (4.0_f64, 6.0_f64);
    let across = 3.0 / 20.0 * r * r + 3.0 / 80.0 * h * h;
    weighs(
        &Shape::cone_part(&HERE, r, 0.0, h, 360.0).unwrap(),
        PI * r * r * h / 3.0,
        PI * r * (r + r.hypot(h)),
        [0.0, 0.0, h / 4.0],
        [across, across, 0.3 * r * r],
    );
    let t = 1.0_f64;
    let frustum = Shape::cone_part(&HERE, r, t, h, 360.0).unwrap();
    is(
        &frustum,
        PI * h / 3.0 * (r * r + r * t + t * t),
        PI * (r + t) * h.hypot(r - t) + PI * (r * r + t * t),
    );
    near(
        mass(&frustum).center[2],
        h * (r * r + 2.0 * r * t + 3.0 * t * t) / (4.0 * (r * r + r * t + t * t)),
        1e-12,
    );
}

#[test]
fn a_sphere_and_a_half() {
    let r = 5.0;
    weighs(
        &Shape::sphere(&Frame::WORLD, r).unwrap(),
        4.0 / 3.0 * PI * r * r * r,
        4.0 * PI * r * r,
        [0.0; 3],
        [0.4 * r * r; 3],
    );
    let across = (0.4 - 9.0 / 64.0) * r * r;
    weighs(
        &Shape::sphere_part(&HERE, r, 0.0, 90.0, 360.0).unwrap(),
        2.0 / 3.0 * PI * r * r * r,
        3.0 * PI * r * r,
        [0.0, 0.0, 3.0 / 8.0 * r],
        [across, across, 0.4 * r * r],
    );
}

#[test]
fn a_torus_and_a_ring_of_elliptic_section() {
    let (big, r) = (5.0, 2.0);
    let across = big * big / 2.0 + 5.0 / 8.0 * r * r;
    weighs(
        &Shape::torus(&HERE, big, r).unwrap(),
        2.0 * PI * PI * big * r * r,
        4.0 * PI * PI * big * r,
        [0.0; 3],
        [across, across, big * big + 0.75 * r * r],
    );
    // Pappus's theorems, on a surface that is no elementary one.
    let (a, b) = (2.0_f64, 1.0_f64);
    let at = Placement::translation(big, 0.0, 0.0);
    let ring = face(&[Shape::ellipse_edge(&at, a, b, 20.0).unwrap()]);
    let ring = ring.turned([0.0; 3], [0.0, 1.0, 0.0], 360.0).unwrap();
    let girth = around(|t| (a * t.sin()).hypot(b * t.cos()));
    is(&ring, TAU * big * PI * a * b, TAU * big * girth);
}

#[test]
fn an_elliptic_prism() {
    let (a, b, h) = (10.0_f64, 6.0_f64, 5.0);
    let shape = prism(&[Shape::ellipse_edge(&HERE, a, b, 0.0).unwrap()], h);
    let girth = around(|t| (a * t.sin()).hypot(b * t.cos()));
    weighs(
        &shape,
        PI * a * b * h,
        2.0 * PI * a * b + h * girth,
        [0.0, 0.0, h / 2.0],
        [
            b * b / 4.0 + h * h / 12.0,
            a * a / 4.0 + h * h / 12.0,
            (a * a + b * b) / 4.0,
        ],
    );
}

#[test]
fn a_tapered_prism_and_a_wedge() {
    let (a, b, h) = (10.0, 8.0, 3.0);
    let corners = [[0.0, 0.0, 0.0], [a, 0.0, 0.0], [a, b, 0.0], [0.0, b, 0.0]];
    let wire = Shape::polyline_wire(&corners, true).unwrap();
    let base = Shape::face(&wire, &[]).unwrap();
    let tapered = base.extruded([0.0, 0.0, h], 10.0).unwrap();
    // The prismoidal formula, which is exact for these.
    let slope = 10.0_f64.to_radians().tan();
    let at = |z: f64| (a - 2.0 * z * slope) * (b - 2.0 * z * slope);
    let side = (a + b + a + b - 8.0 * h * slope / 2.0) * h.hypot(h * slope);
    is(
        &tapered,
        h / 6.0 * (at(0.0) + 4.0 * at(h / 2.0) + at(h)),
        at(0.0) + at(h) + side,
    );
    let wedge = Shape::wedge(&HERE, 6.0, 4.0, 5.0, 1.0, 2.0, 3.0, 4.0).unwrap();
    let middle = f64::midpoint(6.0, 2.0) * f64::midpoint(5.0, 2.0);
    near(
        mass(&wedge).volume,
        4.0 / 6.0 * (30.0 + 4.0 * middle + 4.0),
        1e-12,
    );
}

/// The slopes of the cubic spline through values at parameters with these slopes at its ends: the
/// equations of continuous curvature, solved by Thomas's algorithm.
fn slopes(t: &[f64], y: &[f64], first: f64, last: f64) -> Vec<f64> {
    let n = y.len();
    let (mut upper, mut right) = (vec![0.0; n], vec![first; n]);
    for i in 1..n - 1 {
        let (before, after) = (t[i] - t[i - 1], t[i + 1] - t[i]);
        let rise = 3.0 * ((y[i] - y[i - 1]) * after / before + (y[i + 1] - y[i]) * before / after);
        let pivot = 2.0 * (before + after) - after * upper[i - 1];
        upper[i] = before / pivot;
        right[i] = (rise - after * right[i - 1]) / pivot;
    }
    let mut out = vec![last; n];
    for i in (0..n - 1).rev() {
        out[i] = right[i] - upper[i] * out[i + 1];
    }
    out
}

#[test]
fn a_prism_under_a_spline() {
    let t = [0.0, 1.0, 2.5, 3.0, 4.5, 6.0, 6.5];
    let x = [0.0, 2.0, 3.0, 5.0, 6.0, 9.0, 10.0];
    let y = [0.0, 3.0, 2.0, 4.0, 1.0, 3.0, 0.0];
    let points: Vec<[f64; 3]> = x.iter().zip(y).map(|(x, y)| [*x, y, 0.0]).collect();
    let spline = Shape::spline_edge(&Spline {
        points: &points,
        tangents: Some(&[Some([1.0, 2.0, 0.0]), Some([1.5, -3.0, 0.0])]),
        periodic: false,
        parameters: Some(&t),
        scale: false,
        tolerance: 1e-6,
    })
    .unwrap();
    let chord = Shape::line_edge([10.0, 0.0, 0.0], [0.0; 3]).unwrap();
    let h = 4.0;
    let shape = prism(&[spline, chord], h);

    let (mx, my) = (slopes(&t, &x, 1.0, 1.5), slopes(&t, &y, 2.0, -3.0));
    // A value and its derivative on the Hermite cubic of a stretch, at a share of it.
    let cubic = |v: &[f64], m: &[f64], i: usize, s: f64| {
        let h = t[i + 1] - t[i];
        let rise = v[i + 1] - v[i];
        let (c, d) = (
            3.0 * rise - h * (2.0 * m[i] + m[i + 1]),
            -2.0 * rise + h * (m[i] + m[i + 1]),
        );
        (
            v[i] + s * (h * m[i] + s * (c + s * d)),
            h * m[i] + s * (2.0 * c + s * 3.0 * d),
        )
    };
    // Gauss's rule of three points, on many pieces of each stretch.
    let (mut under, mut moment, mut length) = (0.0, 0.0, 0.0);
    let pieces = 400;
    for i in 0..t.len() - 1 {
        for k in 0..pieces {
            for (node, w) in [(-(0.6_f64.sqrt()), 5.0), (0.0, 8.0), (0.6_f64.sqrt(), 5.0)] {
                let step = 1.0 / f64::from(pieces);
                let s = (f64::from(k) + 0.5 + 0.5 * node) * step;
                let ((px, dx), (py, dy)) = (cubic(&x, &mx, i, s), cubic(&y, &my, i, s));
                let w = w / 18.0 * step;
                under += w * py * dx;
                moment += w * py * px * dx;
                length += w * dx.hypot(dy);
            }
        }
    }
    let m = mass(&shape);
    near(m.volume, under * h, 1e-11);
    near(m.area, 2.0 * under + (length + 10.0) * h, 1e-11);
    near(m.center[0], moment / under, 1e-10);
    // As a sheet.
    let sheets = shape.parts(Topology::Face).unwrap();
    let sum: f64 = sheets.iter().map(|f| f.measure().unwrap().area).sum();
    near(sum, m.area, 1e-12);
}

#[test]
fn a_rounded_box() {
    let ([a, b, c], r) = ([10.0, 8.0, 6.0], 1.5);
    let block = cuboid([a, b, c]);
    let edges = block.parts(Topology::Edge).unwrap();
    let round = block
        .filleted(&edges.iter().collect::<Vec<_>>(), r)
        .unwrap();
    // Steiner's formula for the box of the centres of the balls.
    let [p, q, s] = [a - 2.0 * r, b - 2.0 * r, c - 2.0 * r];
    let (flat, long) = (2.0 * (p * q + q * s + s * p), p + q + s);
    is(
        &round,
        p * q * s + flat * r + PI * r * r * long + 4.0 / 3.0 * PI * r * r * r,
        flat + TAU * r * long + 4.0 * PI * r * r,
    );
}

#[test]
fn a_cavity_and_a_tray() {
    let block = cuboid([10.0, 8.0, 6.0]);
    let closed = block.hollowed(&[], -1.0, Corner::Intersection).unwrap();
    is(&closed, 480.0 - 8.0 * 6.0 * 4.0, 376.0 + 208.0);
    let faces = block.parts(Topology::Face).unwrap();
    let top = faces.iter().find(|f| f.center().unwrap()[2] > 5.9).unwrap();
    let tray = block.hollowed(&[top], -1.0, Corner::Intersection).unwrap();
    near(mass(&tray).volume, 480.0 - 8.0 * 6.0 * 5.0, 1e-12);
}

#[test]
fn a_cylinder_with_a_cross_bore() {
    let (big, r, h) = (5.0, 2.0, 20.0);
    let at = Frame::new([-10.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]).unwrap();
    let bore = Shape::cylinder(&at, r, 20.0).unwrap();
    let whole = Shape::cylinder(
        &Frame {
            origin: [0.0, 0.0, -10.0],
            ..Frame::WORLD
        },
        big,
        h,
    )
    .unwrap();
    let shape = whole.without(&[&bore], None).unwrap();
    // Strips of height 2 r cos(t) and depth 2 sqrt(R2 - y2) at y = r sin(t).
    let chord = |t: f64| (big * big - (r * t.sin()).powi(2)).sqrt();
    let removed = around(|t| 2.0 * r * r * t.cos().powi(2) * chord(t));
    near(mass(&shape).volume, PI * big * big * h - removed, 1e-7);
    // Twice the hole in the outer face is lost, the bore's face is won.
    let lost = 2.0 * around(|t| r * r * t.cos().powi(2) * big / chord(t));
    let won = around(|t| 2.0 * r * chord(t));
    near(mass(&shape).area, TAU * big * (big + h) - lost + won, 1e-7);
}

#[test]
fn groups_mirror_images_and_faces_with_holes() {
    let one = cuboid([1.0, 2.0, 3.0]);
    let two = Shape::sphere(&Frame::WORLD, 2.0)
        .unwrap()
        .moved(&Placement::translation(10.0, 0.0, 0.0))
        .unwrap();
    let ball = 32.0 / 3.0 * PI;
    let both = Shape::compound(&[&one, &two]).unwrap();
    is(&both, 6.0 + ball, 22.0 + 16.0 * PI);
    near3(
        mass(&both).center,
        [
            (3.0 + 10.0 * ball) / (6.0 + ball),
            6.0 / (6.0 + ball),
            9.0 / (6.0 + ball),
        ],
    );
    let image = both.mirrored([0.0; 3], [1.0, 1.0, 0.0]).unwrap();
    is(&image, 6.0 + ball, 22.0 + 16.0 * PI);
    // A loose sheet has an area and encloses nothing.
    let sheet = one.parts(Topology::Face).unwrap()[0]
        .moved(&slanted())
        .unwrap();
    let more = Shape::compound(&[&one, &sheet]).unwrap();
    is(&more, 6.0, 22.0 + sheet.measure().unwrap().area);

    let outer = Shape::polyline_wire(
        &[
            [0.0, 0.0, 1.0],
            [9.0, 0.0, 1.0],
            [9.0, 6.0, 1.0],
            [0.0, 6.0, 1.0],
        ],
        true,
    )
    .unwrap();
    let hole = Shape::circle_edge(&Placement::translation(6.0, 3.0, 1.0), 1.0).unwrap();
    let hole = Shape::wire(&[&hole]).unwrap();
    let plate = Shape::face(&outer, &[&hole]).unwrap();
    near(plate.measure().unwrap().area, 54.0 - PI, 1e-13);
    let x = (54.0 * 4.5 - PI * 6.0) / (54.0 - PI);
    near3(plate.center().unwrap(), [x, 3.0, 1.0]);
}

#[test]
fn the_same_numbers_each_time() {
    let shape = prism(&[Shape::ellipse_edge(&HERE, 3.0, 2.0, 0.0).unwrap()], 1.0);
    let again = shape.try_clone().unwrap();
    assert_eq!(mass(&shape), mass(&again));
}

/// Teeth of a line, an arc, a line and an arc.
fn gear(teeth: u32) -> Shape {
    let at = |r: f64, share: f64| {
        let a = share * TAU / f64::from(teeth);
        [r * a.cos(), r * a.sin(), 0.0]
    };
    let arc = |r: f64, from: f64, to: f64| {
        Shape::arc_edge(at(r, from), at(r, f64::midpoint(from, to)), at(r, to)).unwrap()
    };
    let mut edges = Vec::new();
    for k in (0..teeth).map(f64::from) {
        edges.push(arc(18.0, k, k + 0.3));
        edges.push(Shape::line_edge(at(18.0, k + 0.3), at(20.0, k + 0.4)).unwrap());
        edges.push(arc(20.0, k + 0.4, k + 0.8));
        edges.push(Shape::line_edge(at(20.0, k + 0.8), at(18.0, k + 1.0)).unwrap());
    }
    prism(&edges, 5.0)
}

#[test]
fn a_gear() {
    let teeth = 40.0;
    let pitch = TAU / teeth;
    // Sectors of the arcs and triangles of the flanks.
    let flank = |share: f64| 0.5 * 18.0 * 20.0 * (share * pitch).sin();
    let tooth = 0.5 * pitch * (0.3 * 324.0 + 0.4 * 400.0) + flank(0.1) + flank(0.2);
    near(mass(&gear(40)).volume, 5.0 * teeth * tooth, 1e-12);
}

#[test]
#[ignore = "prints times"]
fn times() {
    let star: Vec<[f64; 3]> = (0..40)
        .map(|k| {
            let a = f64::from(k) * TAU / 40.0;
            let r = 10.0 + (5.0 * a).sin();
            [r * a.cos(), r * a.sin(), 0.0]
        })
        .collect();
    let star = Shape::spline_edge(&Spline {
        points: &star,
        tangents: None,
        periodic: true,
        parameters: None,
        scale: true,
        tolerance: 1e-6,
    });
    let block = cuboid([3.0, 4.0, 5.0]);
    let edges = block.parts(Topology::Edge).unwrap();
    let round = block.filleted(&edges.iter().collect::<Vec<_>>(), 0.5);
    for (name, shape) in [
        ("box", block),
        ("gear of 40 teeth", gear(40)),
        ("gear of 200 teeth", gear(200)),
        ("sphere", Shape::sphere(&Frame::WORLD, 5.0).unwrap()),
        ("torus", Shape::torus(&HERE, 5.0, 2.0).unwrap()),
        ("rounded box", round.unwrap()),
        (
            "prism under a spline of 40 points",
            prism(&[star.unwrap()], 5.0),
        ),
    ] {
        let start = Instant::now();
        for _ in 0..20 {
            mass(&shape.try_clone().unwrap());
        }
        let each = start.elapsed().as_secs_f64() / 20.0;
        println!("{name}: {:.4} ms, {}", 1e3 * each, mass(&shape).volume);
    }
}
