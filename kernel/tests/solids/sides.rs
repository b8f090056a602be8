//! On which side points are, against closed forms: how deep a point lies, more than 0 in the material, and
//! never farther from the surface than the form says.

use assemcad_kernel::Shape;
use assemcad_kernel::brep::Spline;
use assemcad_kernel::query::Side;
use assemcad_model::frame::Placement;

use super::common::{Two, at, cuboid, cylinder};

type Depth = fn([f64; 3]) -> f64;

fn in_box(p: [f64; 3], low: [f64; 3], high: [f64; 3]) -> f64 {
    (0..3)
        .map(|i| (p[i] - low[i]).min(high[i] - p[i]))
        .fold(f64::INFINITY, f64::min)
}

fn in_rod(p: [f64; 3], x: f64, y: f64, radius: f64) -> f64 {
    radius - libm::hypot(p[0] - x, p[1] - y)
}

fn drilled(p: [f64; 3]) -> f64 {
    let plate = in_box(p, [0.0; 3], [40.0, 30.0, 10.0]);
    let holes = [(8.0, 8.0, 3.0), (30.0, 15.0, 6.0)].map(|(x, y, r)| -in_rod(p, x, y, r));
    let across = libm::hypot(p[1] - 22.0, p[2] - 5.0) - 2.0;
    plate.min(holes[0]).min(holes[1]).min(across)
}

fn hollow(p: [f64; 3]) -> f64 {
    in_box(p, [0.0; 3], [20.0; 3]).min(-in_box(p, [5.0; 3], [12.0, 15.0, 15.0]))
}

fn cone(p: [f64; 3]) -> f64 {
    // From radius 10 at z = 0 to 4 at z = 8: the wall's normal is (8, 6) / 10.
    let wall = ((10.0 - libm::hypot(p[0], p[1])) * 8.0 - p[2] * 6.0) / 10.0;
    wall.min(p[2]).min(8.0 - p[2])
}

fn torus(p: [f64; 3]) -> f64 {
    3.0 - libm::hypot(libm::hypot(p[0], p[1]) - 12.0, p[2])
}

fn ball_on_a_rod(p: [f64; 3]) -> f64 {
    let ball = 7.0 - libm::hypot(libm::hypot(p[0], p[1]), p[2]);
    ball.max(in_rod(p, 0.0, 0.0, 3.0).min(p[2]).min(15.0 - p[2]))
}

/// Teeth of 1.5 mm along a bar: a plane face with many edges.
fn saw(p: [f64; 3]) -> f64 {
    let share = (p[0] / 2.0).fract() * 2.0;
    let height = 5.0 + 1.5 * (1.0 - (share - 1.0).abs());
    let slope = libm::hypot(1.5, 1.0);
    in_box(p, [0.0, 0.0, 0.0], [60.0, 9.0, 4.0]).min((height - p[1]) / slope)
}

fn cam_radius(angle: f64) -> f64 {
    30.0 + 6.0 * (1.0 - libm::cos(angle))
}

/// The spline through the points is nearer to the curve than 1e-3; its slope is less than 0.2.
fn cam(p: [f64; 3]) -> f64 {
    let wall = (cam_radius(libm::atan2(p[1], p[0])) - libm::hypot(p[0], p[1])) / 1.05;
    let bore = -in_rod(p, 0.0, 0.0, 8.0);
    let side = (wall.abs() - 1e-3).max(0.0).copysign(wall);
    side.min(bore).min(p[2]).min(10.0 - p[2])
}

fn saw_bar() -> Shape {
    let mut points = vec![[0.0, 0.0, 0.0]];
    for i in 0..30 {
        let x = 2.0 * f64::from(i);
        points.extend([[x, 5.0, 0.0], [x + 1.0, 6.5, 0.0]]);
    }
    points.extend([[60.0, 5.0, 0.0], [60.0, 0.0, 0.0]]);
    let wire = Shape::polyline_wire(&points, true).unwrap();
    let face = Shape::face(&wire, &[]).unwrap();
    face.extruded([0.0, 0.0, 4.0], 0.0).unwrap()
}

fn disk_cam() -> Shape {
    let points: Vec<[f64; 3]> = (0..72)
        .map(|i| {
            let angle = f64::from(i) * core::f64::consts::TAU / 72.0;
            let r = cam_radius(angle);
            [r * libm::cos(angle), r * libm::sin(angle), 0.0]
        })
        .collect();
    let spline = Spline {
        points: &points,
        tangents: None,
        periodic: true,
        parameters: None,
        scale: true,
        tolerance: 1e-6,
    };
    let wire = Shape::wire(&[&Shape::spline_edge(&spline).unwrap()]).unwrap();
    let face = Shape::face(&wire, &[]).unwrap();
    let disk = face.extruded([0.0, 0.0, 10.0], 0.0).unwrap();
    disk.cut(&cylinder([0.0, 0.0, -1.0], 8.0, 12.0))
}

fn solids() -> Vec<(&'static str, Shape, Depth)> {
    let along_x = Placement::rotation_about([0.0; 3], [0.0, 1.0, 0.0], 90.0).unwrap();
    let start = Placement::translation(-1.0, 22.0, 5.0) * along_x;
    let across = Shape::cylinder_part(&start, 2.0, 42.0, 360.0).unwrap();
    let plate = cuboid([0.0; 3], [40.0, 30.0, 10.0])
        .cut(&cylinder([8.0, 8.0, -1.0], 3.0, 12.0))
        .cut(&cylinder([30.0, 15.0, -1.0], 6.0, 12.0))
        .cut(&across);
    let ball = Shape::sphere(&at(0.0, 0.0, 0.0), 7.0).unwrap();
    vec![
        ("plate", plate, drilled),
        (
            "hollow",
            cuboid([0.0; 3], [20.0; 3]).cut(&cuboid([5.0; 3], [7.0, 10.0, 10.0])),
            hollow,
        ),
        (
            "cone",
            Shape::cone(&at(0.0, 0.0, 0.0), 10.0, 4.0, 8.0).unwrap(),
            cone,
        ),
        (
            "torus",
            Shape::torus(&Placement::IDENTITY, 12.0, 3.0).unwrap(),
            torus,
        ),
        (
            "ball",
            ball.fuse(&cylinder([0.0; 3], 3.0, 15.0)),
            ball_on_a_rod,
        ),
        ("saw", saw_bar(), saw),
        ("cam", disk_cam(), cam),
    ]
}

/// Points in a box around a solid: spread evenly, and on planes and lines of its symmetry.
fn points(solid: &Shape, spread: u32) -> Vec<[f64; 3]> {
    let bounds = solid.bounds().unwrap();
    let size = bounds.size();
    let mut out: Vec<[f64; 3]> = (0..spread)
        .map(|n| {
            // Roots of primes (Weyl).
            [2.0_f64, 3.0, 5.0].map(|prime| (f64::from(n + 1) * prime.sqrt()).fract())
        })
        .collect();
    let marks = [0.0, 0.25, 0.5, 0.75, 1.0];
    for x in marks {
        for y in marks {
            out.extend(marks.map(|z| [x, y, z]));
        }
    }
    for p in &mut out {
        for i in 0..3 {
            p[i] = bounds.min[i] - 0.5 + p[i] * (size[i] + 1.0);
        }
    }
    out
}

fn side(depth: f64) -> Side {
    if depth > 0.0 {
        Side::Inside
    } else {
        Side::Outside
    }
}

#[test]
fn points_lie_where_the_closed_form_says() {
    for (name, solid, depth) in solids() {
        let points = points(&solid, 400);
        let found = solid.classify(&points, 1e-7).unwrap();
        let (mut told, mut inside) = (0, 0);
        for (p, found) in points.iter().zip(found) {
            let depth = depth(*p);
            if depth.abs() > 1e-5 {
                assert_eq!(found, side(depth), "{name} at {p:?}, {depth} mm deep");
                told += 1;
                inside += usize::from(depth > 0.0);
            }
        }
        // The solids fill their boxes between a tenth and nine tenths.
        assert!(
            told > 350 && inside > 40 && told - inside > 40,
            "{name}: {inside} of {told}"
        );
    }
}

#[test]
fn a_moved_solid_has_its_points_moved() {
    let way = Placement::rotation_about([1.0, 2.0, 3.0], [1.0, -2.0, 0.5], 37.0).unwrap();
    for (name, solid, depth) in solids() {
        for moved in [solid.moved(&way).unwrap(), solid.placed(&way).unwrap()] {
            let points = points(&solid, 100);
            let there: Vec<[f64; 3]> = points.iter().map(|p| way.point(*p)).collect();
            for (p, found) in points.iter().zip(moved.classify(&there, 1e-7).unwrap()) {
                let depth = depth(*p);
                if depth.abs() > 1e-5 {
                    assert_eq!(found, side(depth), "{name} at {p:?}");
                }
            }
        }
    }
}

#[test]
fn what_is_nearer_to_the_surface_than_the_tolerance_is_on_it() {
    let plate = cuboid([0.0; 3], [40.0, 30.0, 10.0]).cut(&cylinder([20.0, 15.0, -1.0], 6.0, 12.0));
    let cone = Shape::cone(&at(0.0, 0.0, 0.0), 10.0, 4.0, 8.0).unwrap();
    let torus = Shape::torus(&Placement::IDENTITY, 12.0, 3.0).unwrap();
    let ball = Shape::sphere(&at(0.0, 0.0, 0.0), 7.0).unwrap();
    let (sin, cos) = libm::sincos(0.7);
    // A point of the surface and the way out of the material there.
    let on: [(&Shape, [f64; 3], [f64; 3]); 8] = [
        (&plate, [3.0, 4.0, 10.0], [0.0, 0.0, 1.0]),
        (&plate, [40.0, 4.0, 3.0], [1.0, 0.0, 0.0]),
        (
            &plate,
            [20.0 + 6.0 * cos, 15.0 + 6.0 * sin, 3.0],
            [-cos, -sin, 0.0],
        ),
        // On the edge of the bore, and on a corner.
        (
            &plate,
            [20.0 + 6.0 * cos, 15.0 + 6.0 * sin, 10.0],
            [0.0, 0.0, 1.0],
        ),
        (&plate, [40.0, 30.0, 10.0], [0.0, 1.0, 0.0]),
        (
            &cone,
            [7.0 * cos, 7.0 * sin, 4.0],
            [0.8 * cos, 0.8 * sin, 0.6],
        ),
        (
            &torus,
            [
                cos * (12.0 + 3.0 * cos),
                sin * (12.0 + 3.0 * cos),
                3.0 * sin,
            ],
            [cos * cos, sin * cos, sin],
        ),
        (&ball, [7.0 * cos, 0.0, 7.0 * sin], [cos, 0.0, sin]),
    ];
    for (n, (solid, point, out)) in on.into_iter().enumerate() {
        let moved = |by: f64| core::array::from_fn(|i| point[i] + by * out[i]);
        let sides = solid
            .classify(&[moved(0.0), moved(5e-5), moved(5e-4)], 1e-4)
            .unwrap();
        assert_eq!(
            sides,
            [Side::Boundary, Side::Boundary, Side::Outside],
            "{n}"
        );
        // At the tolerance of probes too, and from within.
        let sides = solid.classify(&[moved(5e-7), moved(5e-6)], 1e-6).unwrap();
        assert_eq!(sides, [Side::Boundary, Side::Outside], "{n}");
        if ![3, 4].contains(&n) {
            let sides = solid.classify(&[moved(-5e-7), moved(-5e-6)], 1e-6).unwrap();
            assert_eq!(sides, [Side::Boundary, Side::Inside], "{n}");
        }
    }
    // In the plane of a face and beside it, or in the bore: on nothing.
    let beside = [
        [45.0, 15.0, 10.0],
        [20.0, 15.0, 10.0],
        [20.0, 15.0, 0.0],
        [20.0, 20.0, 10.0],
    ];
    let sides = plate.classify(&beside, 1e-4).unwrap();
    assert_eq!(sides, [Side::Outside; 4]);
}
