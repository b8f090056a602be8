//! The bridge to the C++ of shapes of any kind: nothing but declarations, as in [`crate::ffi`].

#![allow(unsafe_code, missing_docs)]
#![allow(clippy::indexing_slicing, clippy::expect_used, clippy::unwrap_used)]

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
    }
}
