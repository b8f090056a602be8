//! Input that makes no sense comes back as a sentence, not as a crash.

use assemcad_kernel::Shape;
use assemcad_kernel::brep::{Corner, Spline, Sweep, Topology, Transition};
use assemcad_model::frame::Placement;

use crate::common::*;

#[test]
fn numbers_that_are_none() {
    let nan = f64::NAN;
    says(
        Shape::line_edge([nan, 0.0, 0.0], [1.0, 0.0, 0.0]),
        "not finite",
    );
    says(Shape::circle_edge(&WORLD, nan), "not a finite number");
    says(Shape::circle_edge(&WORLD, -1.0), "more than 0");
    says(Shape::circle_arc_edge(&WORLD, 1.0, nan, 0.0), "NaN degrees");
    says(
        Shape::circle_edge(&Placement::translation(nan, 0.0, 0.0), 1.0),
        "not finite",
    );
    says(
        Shape::helix_wire(1.0, 1.0, 1.0, &WORLD, nan, false),
        "half angle",
    );
    says(
        Shape::helix_wire(1e-5, 1.0, 1.0, &WORLD, 0.0, false),
        "turns",
    );
    says(
        Shape::helix_wire(1.0, 9.0, 1.0, &WORLD, -30.0, false),
        "tip",
    );
    says(Shape::torus(&WORLD, 1.0, 2.0), "reaches its axis");
    says(Shape::cone_part(&WORLD, 1.0, 1.0, 2.0, 360.0), "cylinder");
    says(
        Shape::cylinder_part(&WORLD, 1.0, 1.0, 0.0),
        "over 0 up to 360",
    );
    says(
        Shape::sphere_part(&WORLD, 1.0, 90.0, -90.0, 360.0),
        "latitudes",
    );
    says(
        Shape::wedge(&WORLD, 1.0, 1.0, 1.0, 1.0, 0.0, 0.0, 1.0),
        "inverted",
    );
    let plate = face(&rectangle(0.0, 0.0, 1.0, 1.0, 0.0), &[]);
    says(plate.extruded([0.0, 0.0, nan], 0.0), "not finite");
    says(plate.extruded([0.0; 3], 0.0), "more than 0");
    says(plate.extruded([0.0, 0.0, 1.0], nan), "taper");
    says(plate.turned([0.0; 3], [0.0; 3], 90.0), "no length");
    says(
        plate.turned([0.0; 3], [0.0, 1.0, 0.0], nan),
        "within a full turn",
    );
    says(
        plate.twisted([0.0; 3], [0.0, 0.0, 1.0], 0.0),
        "plain extrusion",
    );
    says(plate.mirrored([0.0; 3], [0.0; 3]), "no length");
    says(plate.without(&[&plate], Some(nan)), "tolerance");
}

#[test]
fn curves_of_nothing() {
    says(
        Shape::line_edge([1.0; 3], [1.0; 3]),
        "two points in one place",
    );
    says(
        Shape::arc_edge([0.0; 3], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0]),
        "lie on one line",
    );
    says(
        Shape::arc_edge([0.0; 3], [1.0, 0.0, 0.0], [0.0; 3]),
        "two points in one place",
    );
    says(
        Shape::tangent_arc_edge([0.0; 3], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0]),
        "straight ahead",
    );
    says(Shape::bezier_edge(&[[0.0; 3]; 3]), "in one place");
    says(Shape::bezier_edge(&[]), "no points");
    let many: Vec<[f64; 3]> = (0..40).map(|i| [f64::from(i), 0.0, 0.0]).collect();
    says(Shape::bezier_edge(&many), "at most 26");
    says(
        Shape::spline_approx_edge(&[[0.0; 3]], 1e-3, 1, 6),
        "at least 2",
    );
    says(Shape::spline_approx_edge(&many, 1e-3, 6, 3), "degrees");
    says(Shape::polyline_wire(&[], true), "at least 2");
    says(Shape::wire(&[]), "nothing to make it of");
    says(
        Shape::wire(&[&cuboid(1.0, 1.0, 1.0)]),
        "edges and wires only",
    );
    let s = Spline {
        points: &[[0.0; 3], [1.0, 0.0, 0.0]],
        tangents: None,
        periodic: true,
        parameters: None,
        scale: true,
        tolerance: 1e-6,
    };
    says(Shape::spline_edge(&s), "at least 3");
    let points = [[0.0; 3], [1.0, 0.0, 0.0], [2.0, 1.0, 0.0]];
    let s = Spline {
        points: &points,
        periodic: false,
        ..s
    };
    says(
        Shape::spline_edge(&Spline {
            tangents: Some(&[None, Some([1.0, 0.0, 0.0])]),
            ..s
        }),
        "both of its ends",
    );
    says(
        Shape::spline_edge(&Spline {
            parameters: Some(&[0.0, 0.0, 1.0]),
            ..s
        }),
        "do not increase",
    );
    says(
        Shape::spline_edge(&Spline {
            tangents: Some(&[Some([0.0; 3]), Some([1.0, 0.0, 0.0])]),
            ..s
        }),
        "no length",
    );
}

#[test]
fn faces_of_open_or_bent_wires() {
    let open = Shape::polyline_wire(&[[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0]], false).unwrap();
    says(Shape::face(&open, &[]), "not closed");
    let bent = Shape::polyline_wire(
        &[[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 1.0], [0.0, 1.0, 0.0]],
        true,
    )
    .unwrap();
    says(Shape::face(&bent, &[]), "one plane");
    says(
        Shape::face(
            &rectangle(0.0, 0.0, 5.0, 5.0, 0.0),
            &[&circle(2.0, 2.0, 1.0, 1.0)],
        ),
        "one plane",
    );
    says(Shape::faces_from_wires(&[]), "no outline");
    says(open.outer_wire(), "no face");
    says(bent.offset_2d(0.1, Corner::Arc), "one plane only");
    says(
        Shape::line_edge([0.0; 3], [1.0, 0.0, 0.0])
            .unwrap()
            .offset_2d(1.0, Corner::Arc),
        "one plane only",
    );
    let gone = rectangle(0.0, 0.0, 2.0, 2.0, 0.0).offset_2d(-5.0, Corner::Arc);
    assert!(gone.unwrap().is_empty());
    says(
        cuboid(1.0, 1.0, 1.0).offset_2d(1.0, Corner::Arc),
        "wires and edges only",
    );
}

#[test]
fn work_that_does_not_fit() {
    let solid = cuboid(10.0, 10.0, 10.0);
    let edges = solid.parts(Topology::Edge).unwrap();
    let edges: Vec<&Shape> = edges.iter().collect();
    says(solid.filleted(&edges, 100.0), "fillet of 100 mm");
    says(solid.chamfered(&edges, 100.0, None), "chamfer of 100 mm");
    says(solid.filleted(&[], 1.0), "no edges");
    let sides = solid.parts(Topology::Face).unwrap();
    let sides: Vec<&Shape> = sides.iter().collect();
    says(solid.hollowed(&sides, 1.0, Corner::Arc), "no walls");
    let stranger = cuboid(1.0, 1.0, 1.0);
    let foreign = stranger.parts(Topology::Edge).unwrap();
    says(solid.filleted(&[&foreign[0]], 1.0), "none of the solid's");
    says(
        solid.chamfered(&[&foreign[0]], 1.0, None),
        "none of the solid's",
    );
    let faces = stranger.parts(Topology::Face).unwrap();
    says(
        solid.hollowed(&[&faces[0]], 1.0, Corner::Arc),
        "none of the solid's",
    );
    says(
        solid.hollowed(&[], -1.0, Corner::Tangent),
        "arcs or intersections",
    );
    let own = solid.parts(Topology::Face).unwrap();
    says(
        solid.hollowed(&[&own[0]], -20.0, Corner::Arc),
        "wall of -20 mm",
    );
    says(
        rectangle(0.0, 0.0, 1.0, 1.0, 0.0).filleted(&edges, 1.0),
        "no solid",
    );
}

#[test]
fn sweeps_of_nothing() {
    let wire = rectangle(0.0, 0.0, 1.0, 1.0, 0.0);
    says(Shape::lofted(&[&wire], true, true), "at least 2");
    let open = Shape::polyline_wire(&[[0.0, 0.0, 5.0], [1.0, 0.0, 5.0]], false).unwrap();
    says(Shape::lofted(&[&wire, &open], true, false), "some are open");
    says(Shape::lofted(&[&open, &open], true, true), "is open");
    says(
        Shape::lofted(&[&wire, &cuboid(1.0, 1.0, 1.0)], true, true),
        "wires and edges only",
    );
    let path = Shape::line_edge([0.0; 3], [0.0, 0.0, 1.0]).unwrap();
    let solid = cuboid(1.0, 1.0, 1.0);
    let s = Sweep {
        path: &solid,
        solid: true,
        frenet: false,
        transition: Transition::Transformed,
        normal: None,
        aux_spine: None,
    };
    says(wire.swept(&s), "wires and edges only");
    says(
        solid.swept(&Sweep { path: &path, ..s }),
        "wires and edges only",
    );
    says(
        Shape::swept_multi(&[], &Sweep { path: &path, ..s }),
        "no profile",
    );
    says(
        wire.swept(&Sweep {
            path: &path,
            normal: Some([0.0; 3]),
            ..s
        }),
        "no length",
    );
    says(solid.extruded([0.0, 0.0, 1.0], 0.0), "cannot be swept");
    says(Shape::lofted(&[&wire, &wire], true, true), "follows itself");
    for transition in [
        Transition::Transformed,
        Transition::Round,
        Transition::Right,
    ] {
        let flat = Sweep {
            path: &wire,
            transition,
            ..s
        };
        says(
            circle(0.0, 0.0, 0.0, 1.0).swept(&flat),
            "plane of the profile",
        );
    }
    let disc = face(&circle(0.0, 0.0, 0.0, 1.0), &[]);
    says(disc.extruded([0.0, 0.0, 2.0], 45.0), "meet before its end");
    says(solid.fused(&[&disc], false, None), "do not go together");
    says(wire.extruded([0.0, 0.0, 1.0], 5.0), "no face");
    says(
        Shape::extruded_until(&wire, &wire, None, true, true, 0.0),
        "no solid",
    );
    let empty = Shape::compound(&[]).unwrap();
    says(
        empty.extruded([0.0, 0.0, 1.0], 0.0),
        "nothing in the profile",
    );
    says(empty.without(&[&solid], None), "nothing to work on");
    says(empty.extent(), "no extent");
}
