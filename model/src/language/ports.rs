//! The methods that make geometry and its port in one: ours, not CadQuery's.
//!
//! They work where the workplane's points are: z of the plane is the port's z, out of the material.
//! With several points the ports are numbered `NAME_1`, `NAME_2` and so on, and `center` adds a port
//! for the middle of the pattern.

use super::{Kind, Method, Param, Type, optional, real, required, text};

const NAME: Param = required("name", Kind::Text);
const DIAMETER: Param = required("diameter", Kind::Real);
const DEPTH: Param = optional("depth", Kind::Real);
/// Name of the port at the far mouth of a through hole.
const BACK: Param = optional("back", Kind::Text);
/// Name of the port in the middle of a pattern.
const CENTER: Param = optional("center", Kind::Text);
const HAND: Param = text("hand", Kind::Choice(&["right", "left"]), "right");

const fn on(name: &'static str, params: &'static [Param], doc: &'static str) -> Method {
    Method {
        name,
        on: Some(Type::Workplane),
        params,
        gives: Type::Workplane,
        doc,
    }
}

pub(super) static METHODS: &[Method] = &[
    on(
        "Workplane.bore_port",
        &[NAME, DIAMETER, DEPTH, BACK, CENTER],
        "A hole against the plane's normal, through all without a depth, and its BORE port at the mouth; back names a second port at the far mouth.",
    ),
    on(
        "Workplane.shaft_port",
        &[NAME, DIAMETER, required("length", Kind::Real), CENTER],
        "A cylinder along the plane's normal, joined to the solid, and its SHAFT port at half its length.",
    ),
    on(
        "Workplane.hole_with_port",
        &[
            NAME,
            DIAMETER,
            DEPTH,
            optional("bolt_diameter", Kind::Real),
            BACK,
            CENTER,
        ],
        "A hole and its HOLE port; with bolt_diameter a through hole and its CLEARANCE_HOLE port.",
    ),
    on(
        "Workplane.cbore_hole_with_port",
        &[
            NAME,
            DIAMETER,
            required("cboreDiameter", Kind::Real),
            required("cboreDepth", Kind::Real),
            DEPTH,
            BACK,
            CENTER,
        ],
        "A hole with a counterbore and its CBORE_SEAT port on the floor; back names a HOLE port at the far mouth.",
    ),
    on(
        "Workplane.csk_hole_with_port",
        &[
            NAME,
            DIAMETER,
            required("cskDiameter", Kind::Real),
            required("cskAngle", Kind::Real),
            DEPTH,
            BACK,
            CENTER,
        ],
        "A hole with a countersink and its HOLE port where the cone ends.",
    ),
    on(
        "Workplane.tapped_hole_with_port",
        &[
            NAME,
            DIAMETER,
            required("pitch", Kind::Real),
            DEPTH,
            HAND,
            optional("modelled_diameter", Kind::Real),
            BACK,
            CENTER,
        ],
        "A threaded hole, modelled plain at its minor diameter, and its THREAD_INTERNAL port.",
    ),
    on(
        "Workplane.face_port",
        &[
            NAME,
            optional("extent_x", Kind::Real),
            optional("extent_y", Kind::Real),
            optional("hole_diameter", Kind::Real),
            optional("at", Kind::Plane),
        ],
        "The FLAT_FACE port of the selected face: at its centre, x and extents as measured where not given; or at a plane.",
    ),
    on(
        "Workplane.gear_mesh_port",
        &[
            NAME,
            required("module", Kind::Real),
            required("teeth", Kind::Count),
            required("width", Kind::Real),
            real("pressure_angle_deg", 20.0),
            real("profile_shift", 0.0),
            real("thinning", 0.0),
            optional("outline", Kind::Outline),
        ],
        "An involute spur gear along the plane's normal and its GEAR_MESH port at half its width, the middle of a tooth on x.",
    ),
    on(
        "Workplane.snap_port",
        &[
            NAME,
            required("overlap", Kind::Real),
            required("width", Kind::Real),
            required("length", Kind::Real),
            required("thickness", Kind::Real),
            real("lead_angle_deg", 30.0),
        ],
        "A cantilever hook along the plane's normal whose nose looks along x, and its SNAP_FIT port on the locking face.",
    ),
    on(
        "Workplane.port",
        &[
            NAME,
            required("type", Kind::Text),
            required("params", Kind::PortParams),
            optional("at", Kind::Plane),
        ],
        "A port of any type on geometry that is there: at the workplane's points, or at a plane in the part's frame.",
    ),
    on(
        "Workplane.without_ports",
        &[],
        "The same solid with no ports.",
    ),
    on(
        "Workplane.with_ports_of",
        &[
            required("other", Kind::Workplane),
            optional("prefix", Kind::Text),
        ],
        "The ports of another chain too, as they are.",
    ),
];
