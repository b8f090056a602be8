//! The bridge to C++: the only place of `unsafe`, and nothing but declarations.
//!
//! The types here are raw: the modules above check what goes in and name what comes out.

#![allow(unsafe_code, missing_docs)]
#![allow(clippy::indexing_slicing, clippy::expect_used, clippy::unwrap_used)]

#[cxx::bridge(namespace = "assemcad")]
pub mod bridge {
    /// A frame: origin, unit x and z at a right angle.
    #[derive(Debug, Clone, Copy)]
    struct At {
        origin: [f64; 3],
        x: [f64; 3],
        z: [f64; 3],
    }

    /// The rows of a 3 x 4 rigid placement.
    #[derive(Debug, Clone, Copy)]
    struct Pose {
        rows: [f64; 12],
    }

    #[derive(Debug, Clone, Copy)]
    struct BoundsRaw {
        min: [f64; 3],
        max: [f64; 3],
    }

    #[derive(Debug)]
    struct BoresRaw {
        known: bool,
        ends: Vec<f64>,
    }

    #[derive(Debug)]
    struct MassRaw {
        volume: f64,
        area: f64,
        center: [f64; 3],
        inertia: [f64; 9],
    }

    #[derive(Debug)]
    struct CheckRaw {
        reasons: Vec<String>,
        solids: u32,
        closed: bool,
    }

    #[derive(Debug)]
    struct FaceRaw {
        kind: u8,
        inward: bool,
        origin: [f64; 3],
        normal: [f64; 3],
        axis: [f64; 3],
        radius: f64,
        minor_radius: f64,
        half_angle: f64,
        span: f64,
        low: f64,
        high: f64,
        area: f64,
        bounds: BoundsRaw,
    }

    #[derive(Debug)]
    struct EdgeRaw {
        kind: u8,
        turn: u8,
        start: [f64; 3],
        end: [f64; 3],
        middle: [f64; 3],
        tangent: [f64; 3],
        length: f64,
        radius: f64,
        center: [f64; 3],
        axis: [f64; 3],
        bounds: BoundsRaw,
        samples: Vec<f64>,
    }

    #[derive(Debug)]
    struct DistanceRaw {
        distance: f64,
        on_a: [f64; 3],
        on_b: [f64; 3],
    }

    #[derive(Debug)]
    struct CommonRaw {
        volume: f64,
        solids: u32,
        center: [f64; 3],
        bounds: BoundsRaw,
        warnings: Vec<String>,
    }

    #[derive(Debug)]
    struct AreaRaw {
        area: f64,
        warnings: Vec<String>,
    }

    #[derive(Debug)]
    struct MeshRaw {
        positions: Vec<f64>,
        normals: Vec<f64>,
        triangles: Vec<u32>,
        lines: Vec<f64>,
        line_ends: Vec<u32>,
        line_turns: Vec<u8>,
    }

    #[derive(Debug)]
    struct SkinFaceRaw {
        kind: u8,
        shell: u32,
        outward: bool,
        origin: [f64; 3],
        axis: [f64; 3],
        radius: f64,
        other: f64,
        low: f64,
        high: f64,
        off: f64,
        triangles_end: u32,
        edges_end: u32,
    }

    #[derive(Debug)]
    struct SkinEdgeRaw {
        kind: u8,
        turn: u8,
        start: [f64; 3],
        end: [f64; 3],
        middle: [f64; 3],
        center: [f64; 3],
        axis: [f64; 3],
        radius: f64,
        sweep: f64,
        off: f64,
    }

    #[derive(Debug)]
    struct SkinRaw {
        faces: Vec<SkinFaceRaw>,
        edges: Vec<SkinEdgeRaw>,
        face_edges: Vec<u32>,
        positions: Vec<f64>,
        triangles: Vec<u32>,
    }

    #[derive(Debug)]
    struct HeaderRaw {
        name: String,
        time_stamp: String,
        description: Vec<String>,
        author: Vec<String>,
        organization: Vec<String>,
        preprocessor: String,
        originating_system: String,
        authorisation: String,
    }

    #[derive(Debug)]
    struct LeafRaw {
        path: Vec<String>,
        product: String,
        solids: u32,
        volume: f64,
        own_center: [f64; 3],
        center: [f64; 3],
        inertia: [f64; 9],
        bounds: BoundsRaw,
        pose: Pose,
    }

    unsafe extern "C++" {
        include!("assemcad-kernel/cpp/shim.h");

        type Solid;
        type StepDoc;

        fn quiet() -> Result<()>;

        fn make_box(at: &At, dx: f64, dy: f64, dz: f64) -> Result<UniquePtr<Solid>>;
        fn make_cylinder(at: &At, radius: f64, height: f64) -> Result<UniquePtr<Solid>>;
        fn make_cone(at: &At, base: f64, top: f64, height: f64) -> Result<UniquePtr<Solid>>;
        fn make_sphere(at: &At, radius: f64) -> Result<UniquePtr<Solid>>;
        fn has_locations(solid: &Solid) -> Result<bool>;
        fn bounds(solid: &Solid, pose: &Pose) -> Result<BoundsRaw>;
        fn mass(solid: &Solid) -> Result<MassRaw>;
        fn check(solid: &Solid) -> Result<CheckRaw>;
        fn classify(solid: &Solid, points: &[f64], tolerance: f64) -> Result<Vec<u8>>;
        fn bores(solid: &Solid, from: &At, radius: f64, depth: f64) -> Result<BoresRaw>;
        fn faces(solid: &Solid) -> Result<Vec<FaceRaw>>;
        fn edges(solid: &Solid) -> Result<Vec<EdgeRaw>>;
        fn distance(a: &Solid, at_a: &Pose, b: &Solid, at_b: &Pose) -> Result<DistanceRaw>;
        fn common_part(a: &Solid, at_a: &Pose, b: &Solid, at_b: &Pose) -> Result<CommonRaw>;
        fn face_common(
            a: &Solid,
            at_a: &Pose,
            face_a: u32,
            b: &Solid,
            at_b: &Pose,
            face_b: u32,
        ) -> Result<AreaRaw>;
        fn mesh(solid: &Solid, deflection: f64, angle: f64) -> Result<MeshRaw>;
        fn skin(solid: &Solid, deflection: f64, angle: f64) -> Result<SkinRaw>;

        fn to_bytes(solid: &Solid) -> Result<Vec<u8>>;
        fn from_bytes(bytes: &[u8]) -> Result<UniquePtr<Solid>>;

        fn step_doc() -> Result<UniquePtr<StepDoc>>;
        fn add_part(
            self: Pin<&mut StepDoc>,
            name: &str,
            solid: &Solid,
            color: &[f64],
        ) -> Result<u32>;
        fn add_assembly(self: Pin<&mut StepDoc>, name: &str) -> Result<u32>;
        fn add_instance(
            self: Pin<&mut StepDoc>,
            assembly: u32,
            of: u32,
            name: &str,
            pose: &Pose,
        ) -> Result<()>;
        fn write(self: Pin<&mut StepDoc>, header: &HeaderRaw) -> Result<Vec<u8>>;
        fn read_step(bytes: &[u8]) -> Result<Vec<LeafRaw>>;
    }
}
