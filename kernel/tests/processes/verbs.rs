//! The verbs on shapes of any kind, each on something that has many edges or faces.

use assemcad_kernel::Shape;
use assemcad_kernel::brep::{Corner, Side, Sweep, Topology, Transition};
use assemcad_kernel::section;
use assemcad_model::frame::Placement;

const WORLD: Placement = Placement::IDENTITY;
const UP: [f64; 3] = [0.0, 0.0, 1.0];

fn rect(x0: f64, y0: f64, x1: f64, y1: f64, z: f64) -> Shape {
    Shape::polyline_wire(&[[x0, y0, z], [x1, y0, z], [x1, y1, z], [x0, y1, z]], true).unwrap()
}
fn circle(x: f64, y: f64, z: f64, radius: f64) -> Shape {
    let edge = Shape::circle_edge(&Placement::translation(x, y, z), radius).unwrap();
    Shape::wire(&[&edge]).unwrap()
}
fn face(outer: &Shape, holes: &[&Shape]) -> Shape {
    Shape::face(outer, holes).unwrap()
}
fn cuboid([a, b, c]: [f64; 3], x: f64, y: f64, z: f64) -> Shape {
    face(&rect(a, b, a + x, b + y, c), &[])
        .extruded([0.0, 0.0, z], 0.0)
        .unwrap()
}
/// An L with an arc.
fn ell(z: f64) -> Shape {
    let p = [
        [0.0, 0.0, z],
        [20.0, 0.0, z],
        [20.0, 8.0, z],
        [10.0, 8.0, z],
    ];
    let mut e: Vec<Shape> = p
        .windows(2)
        .map(|w| Shape::line_edge(w[0], w[1]).unwrap())
        .collect();
    e.push(Shape::arc_edge([10.0, 8.0, z], [6.0, 10.0, z], [5.0, 15.0, z]).unwrap());
    e.push(Shape::line_edge([5.0, 15.0, z], [0.0, 15.0, z]).unwrap());
    e.push(Shape::line_edge([0.0, 15.0, z], [0.0, 0.0, z]).unwrap());
    Shape::wire(&e.iter().collect::<Vec<_>>()).unwrap()
}
fn poly_ell(z: f64) -> Shape {
    let p = [
        [0.0, 0.0, z],
        [20.0, 0.0, z],
        [20.0, 8.0, z],
        [10.0, 8.0, z],
        [5.0, 15.0, z],
        [0.0, 15.0, z],
    ];
    Shape::polyline_wire(&p, true).unwrap()
}
fn spline() -> Shape {
    let points: Vec<[f64; 3]> = (0..5)
        .map(|i| {
            let t = f64::from(i) * 10.0;
            [
                3.0 * libm::sin(t / 12.0),
                2.0 * libm::cos(t / 15.0) - 2.0,
                t,
            ]
        })
        .collect();
    Shape::spline_approx_edge(&points, 1e-3, 1, 6).unwrap()
}
fn tilted() -> Placement {
    Placement::rotation_about([1.0, 2.0, 3.0], [1.0, -2.0, 0.5], 37.0).unwrap()
}
fn ell_solid() -> Shape {
    face(&ell(0.0), &[&circle(3.0, 3.0, 0.0, 1.0)])
        .extruded([0.0, 0.0, 6.0], 0.0)
        .unwrap()
}
fn drilled() -> Shape {
    let block = cuboid([0.0; 3], 50.0, 40.0, 8.0);
    let holes: Vec<Shape> = (0..20)
        .map(|i| {
            let (x, y) = (5.0 + 9.7 * f64::from(i % 5), 5.0 + 9.7 * f64::from(i / 5));
            Shape::cylinder_part(&Placement::translation(x, y, -1.0), 2.0, 10.0, 360.0).unwrap()
        })
        .collect();
    block
        .without(&holes.iter().collect::<Vec<_>>(), None)
        .unwrap()
}
fn bosses() -> Shape {
    let block = cuboid([0.0; 3], 50.0, 40.0, 8.0);
    let on: Vec<Shape> = (0..12)
        .map(|i| {
            let (x, y) = (4.0 + 12.0 * f64::from(i % 4), 4.0 + 12.0 * f64::from(i / 4));
            cuboid([x, y, 7.0], 6.0, 5.0, 5.0)
        })
        .collect();
    block
        .fused(&on.iter().collect::<Vec<_>>(), false, None)
        .unwrap()
}
fn top(of: &Shape) -> Shape {
    of.parts(Topology::Face)
        .unwrap()
        .into_iter()
        .max_by(|a, b| a.center().unwrap()[2].total_cmp(&b.center().unwrap()[2]))
        .unwrap()
}
fn edges(of: &Shape) -> Vec<Shape> {
    of.parts(Topology::Edge).unwrap()
}
fn refs(of: &[Shape]) -> Vec<&Shape> {
    of.iter().collect()
}
fn along(path: &Shape) -> Sweep<'_> {
    Sweep {
        path,
        solid: true,
        frenet: false,
        transition: Transition::Transformed,
        normal: None,
        aux_spine: None,
    }
}
fn bent() -> Shape {
    Shape::polyline_wire(
        &[
            [0.0; 3],
            [0.0, 0.0, 10.0],
            [10.0, 0.0, 20.0],
            [10.0, 10.0, 20.0],
        ],
        false,
    )
    .unwrap()
}
fn sweep(transition: Transition, frenet: bool) -> Shape {
    face(
        &rect(-1.0, -1.0, 1.0, 1.0, 0.0),
        &[&circle(0.0, 0.0, 0.0, 0.5)],
    )
    .swept(&Sweep {
        transition,
        frenet,
        ..along(&bent())
    })
    .unwrap()
}

/// A name and what is made.
pub type Verb = (&'static str, fn() -> Vec<Shape>);
/// Every verb that might walk a map by addresses.
pub const VERBS: &[Verb] = &[
    ("hollow arc out", || {
        let s = cuboid([0.0; 3], 10.0, 12.0, 14.0);
        vec![s.hollowed(&[&top(&s)], 1.0, Corner::Arc).unwrap()]
    }),
    ("hollow int out ell", || {
        let s = ell_solid();
        vec![s.hollowed(&[&top(&s)], 0.5, Corner::Intersection).unwrap()]
    }),
    ("hollow int in ell", || {
        let s = ell_solid();
        vec![s.hollowed(&[&top(&s)], -0.5, Corner::Intersection).unwrap()]
    }),
    ("hollow closed arc out", || {
        vec![
            cuboid([0.0; 3], 10.0, 12.0, 14.0)
                .hollowed(&[], 1.0, Corner::Arc)
                .unwrap(),
        ]
    }),
    ("hollow closed arc in", || {
        vec![
            cuboid([0.0; 3], 10.0, 12.0, 14.0)
                .hollowed(&[], -1.0, Corner::Arc)
                .unwrap(),
        ]
    }),
    ("hollow closed int out", || {
        vec![
            ell_solid()
                .hollowed(&[], 0.5, Corner::Intersection)
                .unwrap(),
        ]
    }),
    ("hollow closed int in", || {
        vec![
            ell_solid()
                .hollowed(&[], -0.5, Corner::Intersection)
                .unwrap(),
        ]
    }),
    ("hollow closed cyl", || {
        vec![
            Shape::cylinder_part(&tilted(), 5.0, 10.0, 360.0)
                .unwrap()
                .hollowed(&[], -0.5, Corner::Arc)
                .unwrap(),
        ]
    }),
    ("hollow cyl out arc", || {
        let s = Shape::cylinder_part(&WORLD, 5.0, 10.0, 360.0).unwrap();
        vec![s.hollowed(&[&top(&s)], 0.7, Corner::Arc).unwrap()]
    }),
    ("hollow tilted out arc", || {
        let s = cuboid([0.0; 3], 10.0, 12.0, 14.0)
            .placed(&tilted())
            .unwrap();
        vec![s.hollowed(&[&top(&s)], 0.7, Corner::Arc).unwrap()]
    }),
    ("taper in", || {
        vec![
            face(&rect(-5.0, -5.0, 5.0, 5.0, 0.0), &[])
                .extruded([0.0, 0.0, 5.0], 10.0)
                .unwrap(),
        ]
    }),
    ("taper out", || {
        vec![
            face(&rect(-5.0, -5.0, 5.0, 5.0, 0.0), &[])
                .extruded([0.0, 0.0, 5.0], -10.0)
                .unwrap(),
        ]
    }),
    ("taper in ell hole", || {
        vec![
            face(&ell(0.0), &[&circle(3.0, 3.0, 0.0, 1.0)])
                .extruded([0.0, 0.0, 5.0], 5.0)
                .unwrap(),
        ]
    }),
    ("taper out ell hole", || {
        vec![
            face(&ell(0.0), &[&circle(3.0, 3.0, 0.0, 1.0)])
                .extruded([0.0, 0.0, -5.0], -5.0)
                .unwrap(),
        ]
    }),
    ("taper disc tilted", || {
        vec![
            face(&circle(3.0, 3.0, 0.0, 5.0), &[])
                .extruded([0.0, 0.0, 5.0], 5.0)
                .unwrap()
                .placed(&tilted())
                .unwrap(),
        ]
    }),
    ("until through taper", || {
        let b = cuboid([0.0; 3], 10.0, 10.0, 10.0);
        vec![
            Shape::extruded_until(
                &b,
                &face(&rect(3.0, 3.0, 7.0, 6.0, 10.0), &[]),
                None,
                true,
                false,
                5.0,
            )
            .unwrap(),
        ]
    }),
    ("until next taper", || {
        let b = cuboid([0.0; 3], 10.0, 10.0, 10.0)
            .fused(&[&cuboid([0.0, 0.0, 20.0], 10.0, 10.0, 5.0)], false, None)
            .unwrap();
        let spot = face(&rect(3.0, 3.0, 7.0, 6.0, 10.0), &[]);
        let hits = b
            .faces_hit_by_line([5.0, 5.0, 10.0], UP, Side::Ahead)
            .unwrap();
        vec![Shape::extruded_until(&b, &spot, Some(&hits[0]), false, true, 5.0).unwrap()]
    }),
    ("until through taper add", || {
        let b = cuboid([0.0; 3], 10.0, 10.0, 10.0);
        let spot = face(&rect(3.0, 3.0, 7.0, 6.0, 4.0), &[]);
        vec![Shape::extruded_until(&b, &spot, None, true, false, -5.0).unwrap()]
    }),
    ("hollow tube in", || {
        let s = face(
            &circle(0.0, 0.0, 0.0, 8.0),
            &[&rect(-2.0, -2.0, 2.0, 2.0, 0.0)],
        )
        .extruded([0.0, 0.0, 9.0], 0.0)
        .unwrap();
        vec![s.hollowed(&[&top(&s)], -0.5, Corner::Arc).unwrap()]
    }),
    ("hollow tube out", || {
        let s = face(&circle(0.0, 0.0, 0.0, 8.0), &[&circle(0.0, 0.0, 0.0, 4.0)])
            .extruded([0.0, 0.0, 9.0], 0.0)
            .unwrap();
        vec![s.hollowed(&[], 0.5, Corner::Arc).unwrap()]
    }),
    ("taper waist", || {
        let p = [
            [0.0, 0.0, 0.0],
            [10.0, 0.0, 0.0],
            [12.0, 4.0, 0.0],
            [14.0, 0.0, 0.0],
            [24.0, 0.0, 0.0],
            [24.0, 10.0, 0.0],
            [14.0, 10.0, 0.0],
            [12.0, 6.0, 0.0],
            [10.0, 10.0, 0.0],
            [0.0, 10.0, 0.0],
        ];
        vec![
            face(&Shape::polyline_wire(&p, true).unwrap(), &[])
                .extruded([0.0, 0.0, 3.0], 12.0)
                .unwrap(),
        ]
    }),
    ("until through", || {
        let b = cuboid([0.0; 3], 10.0, 10.0, 10.0);
        vec![
            Shape::extruded_until(
                &b,
                &face(&rect(3.0, 3.0, 7.0, 6.0, 10.0), &[]),
                None,
                true,
                false,
                0.0,
            )
            .unwrap(),
        ]
    }),
    ("until next", || {
        let b = cuboid([0.0; 3], 10.0, 10.0, 10.0)
            .fused(&[&cuboid([0.0, 0.0, 20.0], 10.0, 10.0, 5.0)], false, None)
            .unwrap();
        let spot = face(&circle(4.0, 4.0, 10.0, 2.0), &[]);
        let hits = b
            .faces_hit_by_line([5.0, 5.0, 10.0], UP, Side::Ahead)
            .unwrap();
        vec![Shape::extruded_until(&b, &spot, Some(&hits[0]), false, true, 0.0).unwrap()]
    }),
    ("sweep transformed", || {
        vec![sweep(Transition::Transformed, false)]
    }),
    ("sweep round", || vec![sweep(Transition::Round, false)]),
    ("sweep right", || vec![sweep(Transition::Right, false)]),
    ("sweep frenet", || {
        let path = spline();
        vec![
            face(
                &ell(0.0)
                    .moved(&Placement::translation(-5.0, -5.0, 0.0))
                    .unwrap()
                    .baked()
                    .unwrap(),
                &[],
            )
            .swept(&Sweep {
                frenet: true,
                ..along(&path)
            })
            .unwrap(),
        ]
    }),
    ("sweep corrected", || {
        let path = spline();
        vec![face(&ell(0.0), &[]).swept(&along(&path)).unwrap()]
    }),
    ("sweep aux", || {
        let path = Shape::line_edge([0.0; 3], [0.0, 0.0, 10.0]).unwrap();
        let guide = Shape::line_edge([30.0, 0.0, 0.0], [30.0, 3.0, 10.0]).unwrap();
        vec![
            face(&ell(0.0), &[])
                .swept(&Sweep {
                    aux_spine: Some(&guide),
                    ..along(&path)
                })
                .unwrap(),
        ]
    }),
    ("sweep normal", || {
        vec![
            face(&ell(0.0), &[])
                .swept(&Sweep {
                    normal: Some([0.0, 0.0, 1.0]),
                    ..along(&spline())
                })
                .unwrap(),
        ]
    }),
    ("sweep multi", || {
        let path = Shape::line_edge([0.0; 3], [0.0, 0.0, 10.0]).unwrap();
        let (a, b, c) = (
            rect(-2.0, -2.0, 2.0, 2.0, 0.0),
            circle(0.0, 0.0, 5.0, 2.0),
            rect(-1.0, -3.0, 1.0, 3.0, 10.0),
        );
        vec![Shape::swept_multi(&[&a, &b, &c], &along(&path)).unwrap()]
    }),
    ("helix sweep", || {
        let helix = Shape::helix_wire(3.0, 9.0, 10.0, &WORLD, 360.0, false).unwrap();
        let section =
            Shape::polyline_wire(&[[9.5, 0.0, -1.0], [11.0, 0.0, 0.0], [9.5, 0.0, 1.0]], true)
                .unwrap();
        vec![
            section
                .swept(&Sweep {
                    frenet: true,
                    ..along(&helix)
                })
                .unwrap(),
        ]
    }),
    ("helix sweep fused", || {
        let helix = Shape::helix_wire(3.0, 9.0, 10.0, &WORLD, 360.0, false).unwrap();
        let section =
            Shape::polyline_wire(&[[9.5, 0.0, -1.0], [11.0, 0.0, 0.0], [9.5, 0.0, 1.0]], true)
                .unwrap();
        let thread = section
            .swept(&Sweep {
                frenet: true,
                ..along(&helix)
            })
            .unwrap();
        let rod = Shape::cylinder_part(&Placement::translation(0.0, 0.0, -3.0), 10.0, 15.0, 360.0)
            .unwrap();
        vec![rod.fused(&[&thread], false, None).unwrap()]
    }),
    ("connected wires", || {
        let mut e: Vec<Shape> = Vec::new();
        for i in 0..6 {
            let r = rect(
                f64::from(i) * 20.0,
                0.0,
                f64::from(i) * 20.0 + 7.0,
                5.0,
                0.0,
            );
            e.extend(edges(&r));
        }
        let (odd, even): (Vec<_>, Vec<_>) = e.iter().enumerate().partition(|(i, _)| i % 2 == 1);
        let all: Vec<&Shape> = odd.iter().chain(even.iter()).map(|(_, s)| *s).collect();
        Shape::connected_wires(&all).unwrap()
    }),
    ("connected loose", || {
        let mut e: Vec<Shape> = Vec::new();
        for i in 0..24 {
            let (a, b) = (f64::from(i) * 0.2, f64::from((i + 1) % 24) * 0.2);
            let p = |t: f64| {
                let t = t / 4.8 * core::f64::consts::TAU;
                [10.0 * libm::cos(t), 7.0 * libm::sin(t), 0.0]
            };
            e.push(Shape::line_edge(p(a), p(b)).unwrap());
        }
        let all: Vec<&Shape> = (0..24).map(|i| &e[(i * 7) % 24]).collect();
        Shape::connected_wires(&all).unwrap()
    }),
    ("offset arc", || {
        ell(0.0).offset_2d(2.0, Corner::Arc).unwrap()
    }),
    ("offset int", || {
        poly_ell(0.0).offset_2d(2.0, Corner::Intersection).unwrap()
    }),
    ("offset tan", || {
        poly_ell(0.0).offset_2d(2.0, Corner::Tangent).unwrap()
    }),
    ("offset in", || {
        ell(0.0).offset_2d(-1.5, Corner::Arc).unwrap()
    }),
    ("offset waist", || {
        let p = [
            [0.0, 0.0, 0.0],
            [10.0, 0.0, 0.0],
            [12.0, 4.0, 0.0],
            [14.0, 0.0, 0.0],
            [24.0, 0.0, 0.0],
            [24.0, 10.0, 0.0],
            [14.0, 10.0, 0.0],
            [12.0, 6.0, 0.0],
            [10.0, 10.0, 0.0],
            [0.0, 10.0, 0.0],
        ];
        Shape::polyline_wire(&p, true)
            .unwrap()
            .offset_2d(-1.5, Corner::Arc)
            .unwrap()
    }),
    ("mirrored", || {
        vec![
            ell_solid()
                .mirrored([1.0, 2.0, 3.0], [1.0, 1.0, 0.3])
                .unwrap(),
        ]
    }),
    ("baked", || {
        vec![ell_solid().moved(&tilted()).unwrap().baked().unwrap()]
    }),
    ("twisted", || {
        vec![
            face(&ell(0.0), &[&circle(3.0, 3.0, 0.0, 1.0)])
                .twisted([5.0, 5.0, 0.0], [0.0, 0.0, 20.0], 75.0)
                .unwrap(),
        ]
    }),
    ("turned", || {
        vec![
            face(&ell(0.0), &[&circle(3.0, 3.0, 0.0, 1.0)])
                .turned([-3.0, 0.0, 0.0], [-3.0, 1.0, 0.0], 270.0)
                .unwrap(),
        ]
    }),
    ("turned full", || {
        vec![
            face(&ell(0.0), &[&circle(3.0, 3.0, 0.0, 1.0)])
                .turned([-3.0, 0.0, 0.0], [-3.0, 1.0, 0.0], 360.0)
                .unwrap(),
        ]
    }),
    ("loft ruled", || {
        vec![
            Shape::lofted(
                &[
                    &rect(-5.0, -5.0, 5.0, 5.0, 0.0),
                    &circle(0.0, 0.0, 8.0, 2.0),
                ],
                true,
                true,
            )
            .unwrap(),
        ]
    }),
    ("loft smooth", || {
        vec![
            Shape::lofted(
                &[
                    &rect(-5.0, -5.0, 5.0, 5.0, 0.0),
                    &circle(0.0, 0.0, 8.0, 2.0),
                    &rect(-4.0, -2.0, 4.0, 2.0, 15.0),
                ],
                false,
                true,
            )
            .unwrap(),
        ]
    }),
    ("fillet drilled", || {
        let s = drilled();
        vec![s.filleted(&refs(&edges(&s)), 0.5).unwrap()]
    }),
    ("fillet bosses", || {
        let s = bosses();
        vec![s.filleted(&refs(&edges(&s)), 0.4).unwrap()]
    }),
    ("fillet ell", || {
        let s = ell_solid();
        vec![s.filleted(&refs(&edges(&s)), 0.4).unwrap()]
    }),
    ("chamfer drilled", || {
        let s = drilled();
        vec![s.chamfered(&refs(&edges(&s)), 0.5, Some(0.3)).unwrap()]
    }),
    ("chamfer bosses", || {
        let s = bosses();
        vec![s.chamfered(&refs(&edges(&s)), 0.4, None).unwrap()]
    }),
    ("drilled", || vec![drilled()]),
    ("drilled cleaned", || vec![drilled().cleaned().unwrap()]),
    ("bosses cleaned", || vec![bosses().cleaned().unwrap()]),
    ("fused row cleaned", || {
        let row: Vec<Shape> = (1..15)
            .map(|i| cuboid([f64::from(i) * 3.0, 0.0, 0.0], 3.0, 5.0, 4.0))
            .collect();
        vec![
            cuboid([0.0; 3], 3.0, 5.0, 4.0)
                .fused(&refs(&row), false, None)
                .unwrap()
                .cleaned()
                .unwrap(),
        ]
    }),
    ("fillet bosses cleaned", || {
        let s = bosses();
        vec![
            s.filleted(&refs(&edges(&s)), 0.4)
                .unwrap()
                .cleaned()
                .unwrap(),
        ]
    }),
    ("split", || {
        let s = drilled();
        let cut = face(&rect(-10.0, -10.0, 60.0, 60.0, 4.0), &[]);
        let other = face(
            &Shape::polyline_wire(
                &[
                    [20.0, -5.0, -5.0],
                    [20.0, 50.0, -5.0],
                    [20.0, 50.0, 20.0],
                    [20.0, -5.0, 20.0],
                ],
                true,
            )
            .unwrap(),
            &[],
        );
        vec![s.split_by(&[&cut, &other]).unwrap()]
    }),
    ("common", || {
        vec![drilled().shared(&[&bosses()], None).unwrap()]
    }),
    ("glued", || {
        vec![
            cuboid([0.0; 3], 3.0, 5.0, 4.0)
                .fused(
                    &[
                        &cuboid([3.0, 0.0, 0.0], 3.0, 5.0, 4.0),
                        &cuboid([6.0, 0.0, 0.0], 3.0, 5.0, 4.0),
                    ],
                    true,
                    None,
                )
                .unwrap(),
        ]
    }),
    ("balls fused", || {
        let row: Vec<Shape> = (1..8)
            .map(|i| {
                Shape::sphere_part(
                    &Placement::translation(f64::from(i) * 3.0, f64::from(i % 2), 0.0),
                    2.5,
                    -90.0,
                    90.0,
                    360.0,
                )
                .unwrap()
            })
            .collect();
        vec![
            Shape::torus(&WORLD, 6.0, 1.0)
                .unwrap()
                .fused(&refs(&row), false, None)
                .unwrap(),
        ]
    }),
    ("behind a plane", || {
        let left = section::behind(&drilled(), [1.0, 2.0, 0.5], [0.3, -1.0, 0.2]).unwrap();
        vec![left.unwrap()]
    }),
    ("common of two placed", || {
        let turned = Placement::rotation_about([1.0, 2.0, 0.0], [0.2, 0.1, 1.0], 31.0).unwrap();
        let common = section::shared(&drilled(), &WORLD, &drilled(), &turned).unwrap();
        vec![common.unwrap()]
    }),
];
