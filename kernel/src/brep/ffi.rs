//! The bridge to the C++ of shapes of any kind: nothing but declarations, as in [`crate::ffi`].

#![allow(unsafe_code, missing_docs)]
#![allow(clippy::indexing_slicing, clippy::expect_used, clippy::unwrap_used)]
#![allow(clippy::too_many_arguments)]

#[cxx::bridge(namespace = "assemcad")]
pub mod bridge {
    /// A centre and what it was weighed by.
    #[derive(Debug)]
    struct CenterRaw {
        mass: f64,
        center: [f64; 3],
    }

    #[derive(Debug)]
    struct MeasureRaw {
        length: f64,
        area: f64,
        volume: f64,
    }

    #[derive(Debug)]
    struct PlaneRaw {
        origin: [f64; 3],
        x: [f64; 3],
        z: [f64; 3],
    }

    unsafe extern "C++" {
        include!("assemcad-kernel/cpp/brep.h");

        type Solid = crate::ffi::bridge::Solid;
        type At = crate::ffi::bridge::At;
        type Pose = crate::ffi::bridge::Pose;

        type Bundle;
        fn bundle() -> UniquePtr<Bundle>;
        fn push(self: Pin<&mut Bundle>, shape: &Solid) -> Result<()>;
        fn size(self: &Bundle) -> u32;
        fn at(self: &Bundle, index: u32) -> Result<UniquePtr<Solid>>;

        fn kind_of(shape: &Solid) -> Result<u8>;
        fn parts_of(shape: &Solid, kind: u8) -> Result<UniquePtr<Bundle>>;
        fn ancestors_of(context: &Solid, of: &Solid, kind: u8) -> Result<UniquePtr<Bundle>>;
        fn compound_of(shapes: &Bundle) -> Result<UniquePtr<Solid>>;
        fn children_of(shape: &Solid) -> Result<UniquePtr<Bundle>>;
        fn same_shape(a: &Solid, b: &Solid) -> bool;
        fn another_handle(shape: &Solid) -> Result<UniquePtr<Solid>>;
        fn shape_moved(shape: &Solid, pose: &Pose) -> Result<UniquePtr<Solid>>;
        fn shape_mirrored(
            shape: &Solid,
            point: &[f64; 3],
            normal: &[f64; 3],
        ) -> Result<UniquePtr<Solid>>;
        fn shape_baked(shape: &Solid) -> Result<UniquePtr<Solid>>;

        fn form_of(shape: &Solid) -> Result<u8>;
        fn center_of(shape: &Solid) -> Result<CenterRaw>;
        fn measure_of(shape: &Solid) -> Result<MeasureRaw>;
        fn valid_shape(shape: &Solid) -> Result<bool>;
        fn plane_of(face: &Solid) -> Result<PlaneRaw>;
        fn normal_of(shape: &Solid, near: &[f64]) -> Result<[f64; 3]>;

        fn curve_tangent(curve: &Solid, share: f64) -> Result<[f64; 3]>;
        fn curve_position(curve: &Solid, share: f64) -> Result<[f64; 3]>;
        fn curve_end(curve: &Solid, last: bool) -> Result<[f64; 3]>;
        fn curve_closed(curve: &Solid) -> Result<bool>;
        fn curve_radius(curve: &Solid) -> Result<f64>;

        fn edge_line(from: &[f64; 3], to: &[f64; 3]) -> Result<UniquePtr<Solid>>;
        fn edge_arc(from: &[f64; 3], via: &[f64; 3], to: &[f64; 3]) -> Result<UniquePtr<Solid>>;
        fn edge_tangent_arc(
            from: &[f64; 3],
            tangent: &[f64; 3],
            to: &[f64; 3],
        ) -> Result<UniquePtr<Solid>>;
        fn edge_circle(at: &At, radius: f64) -> Result<UniquePtr<Solid>>;
        fn edge_circle_arc(at: &At, radius: f64, from: f64, to: f64) -> Result<UniquePtr<Solid>>;
        fn edge_ellipse(
            at: &At,
            x_radius: f64,
            y_radius: f64,
            rotation: f64,
        ) -> Result<UniquePtr<Solid>>;
        fn edge_ellipse_arc(
            at: &At,
            x_radius: f64,
            y_radius: f64,
            from: f64,
            to: f64,
            forward: bool,
        ) -> Result<UniquePtr<Solid>>;
        fn edge_spline(
            points: &[f64],
            tangents: &[f64],
            given: &[bool],
            parameters: &[f64],
            periodic: bool,
            scale: bool,
            tolerance: f64,
        ) -> Result<UniquePtr<Solid>>;
        fn edge_spline_approx(
            points: &[f64],
            tolerance: f64,
            min_degree: u32,
            max_degree: u32,
        ) -> Result<UniquePtr<Solid>>;
        fn edge_bezier(points: &[f64]) -> Result<UniquePtr<Solid>>;

        fn wire_of(edges: &Bundle) -> Result<UniquePtr<Solid>>;
        fn wires_connected(curves: &Bundle, tolerance: f64) -> Result<UniquePtr<Bundle>>;
        fn wire_polyline(points: &[f64], close: bool) -> Result<UniquePtr<Solid>>;
        fn wire_helix(
            at: &At,
            pitch: f64,
            height: f64,
            radius: f64,
            half_angle: f64,
            left: bool,
        ) -> Result<UniquePtr<Solid>>;
        fn wire_offset(wire: &Solid, distance: f64, corner: u8) -> Result<UniquePtr<Bundle>>;

        fn face_of_wires(wires: &Bundle) -> Result<UniquePtr<Solid>>;
        fn faces_of_wires(wires: &Bundle) -> Result<UniquePtr<Bundle>>;
        fn outer_wire_of(face: &Solid) -> Result<UniquePtr<Solid>>;
        fn inner_wires_of(face: &Solid) -> Result<UniquePtr<Bundle>>;

        fn extrude(profile: &Solid, vector: &[f64; 3]) -> Result<UniquePtr<Solid>>;
        fn extrude_tapered(face: &Solid, slant: f64, taper: f64) -> Result<UniquePtr<Solid>>;
        fn extrude_until(
            basis: &Solid,
            face: &Solid,
            up_to: &Bundle,
            taper: f64,
            additive: bool,
        ) -> Result<UniquePtr<Solid>>;
        fn faces_on_line(
            shape: &Solid,
            point: &[f64; 3],
            direction: &[f64; 3],
            side: u8,
            tolerance: f64,
        ) -> Result<UniquePtr<Bundle>>;
        fn extrude_twisted(
            face: &Solid,
            center: &[f64; 3],
            vector: &[f64; 3],
            radians: f64,
        ) -> Result<UniquePtr<Solid>>;
        fn turn_about(
            profile: &Solid,
            from: &[f64; 3],
            direction: &[f64; 3],
            radians: f64,
        ) -> Result<UniquePtr<Solid>>;
        fn sweep(
            profile: &Solid,
            path: &Solid,
            guide: &Bundle,
            normal: &[f64],
            frenet: bool,
            solid: bool,
            transition: u8,
        ) -> Result<UniquePtr<Solid>>;
        fn sweep_multi(
            sections: &Bundle,
            path: &Solid,
            guide: &Bundle,
            normal: &[f64],
            frenet: bool,
            solid: bool,
        ) -> Result<UniquePtr<Solid>>;
        fn loft(wires: &Bundle, ruled: bool, solid: bool) -> Result<UniquePtr<Solid>>;

        fn fillet_edges(solid: &Solid, edges: &Bundle, radius: f64) -> Result<UniquePtr<Solid>>;
        fn chamfer_edges(
            solid: &Solid,
            edges: &Bundle,
            first: f64,
            second: f64,
        ) -> Result<UniquePtr<Solid>>;
        fn hollow(
            solid: &Solid,
            open: &Bundle,
            thickness: f64,
            corner: u8,
            tolerance: f64,
        ) -> Result<UniquePtr<Solid>>;
        fn solid_wedge(
            at: &At,
            dx: f64,
            dy: f64,
            dz: f64,
            xmin: f64,
            zmin: f64,
            xmax: f64,
            zmax: f64,
        ) -> Result<UniquePtr<Solid>>;
        fn solid_torus(at: &At, major: f64, minor: f64) -> Result<UniquePtr<Solid>>;
        fn solid_sphere(
            at: &At,
            radius: f64,
            low: f64,
            high: f64,
            turn: f64,
        ) -> Result<UniquePtr<Solid>>;
        fn solid_cylinder(at: &At, radius: f64, height: f64, turn: f64)
        -> Result<UniquePtr<Solid>>;
        fn solid_cone(
            at: &At,
            base: f64,
            top: f64,
            height: f64,
            turn: f64,
        ) -> Result<UniquePtr<Solid>>;

        fn fuse_all(
            shape: &Solid,
            others: &Bundle,
            glue: bool,
            tolerance: f64,
        ) -> Result<UniquePtr<Solid>>;
        fn cut_all(shape: &Solid, tools: &Bundle, tolerance: f64) -> Result<UniquePtr<Solid>>;
        fn common_all(shape: &Solid, others: &Bundle, tolerance: f64) -> Result<UniquePtr<Solid>>;
        fn split_all(shape: &Solid, tools: &Bundle) -> Result<UniquePtr<Solid>>;
        fn cleaned(shape: &Solid) -> Result<UniquePtr<Solid>>;
    }
}
