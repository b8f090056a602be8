//! Shapes made directly and moved: the part of CadQuery's direct API that scripts mostly use.

use super::{Default, Kind, Method, Param, Type, flag, optional, real, required, vector};

const AT: Param = vector("pnt", [0.0; 3]);
const UP: Param = vector("dir", [0.0, 0.0, 1.0]);
const TURN: Param = real("angleDegrees", 360.0);

const fn makes(name: &'static str, params: &'static [Param], doc: &'static str) -> Method {
    Method {
        name,
        on: None,
        params,
        gives: Type::Shape,
        doc,
    }
}

const fn on(name: &'static str, params: &'static [Param], doc: &'static str) -> Method {
    Method {
        name,
        on: Some(Type::Shape),
        params,
        gives: Type::Shape,
        doc,
    }
}

const fn real_of(name: &'static str) -> Param {
    required(name, Kind::Real)
}

pub(super) static METHODS: &[Method] = &[
    // What stands for the argument of a function that is given to each or eachpoint.
    Method {
        name: "eachLocation",
        on: Some(Type::Workplane),
        params: &[],
        gives: Type::Location,
        doc: "The place that a function of eachpoint is given; written by the front end.",
    },
    Method {
        name: "eachObject",
        on: Some(Type::Workplane),
        params: &[],
        gives: Type::Shape,
        doc: "The object that a function of each is given; written by the front end.",
    },
    makes(
        "Solid.makeBox",
        &[
            real_of("length"),
            real_of("width"),
            real_of("height"),
            AT,
            UP,
        ],
        "A box from its corner.",
    ),
    makes(
        "Solid.makeCylinder",
        &[real_of("radius"), real_of("height"), AT, UP, TURN],
        "A cylinder; the radius comes first.",
    ),
    makes(
        "Solid.makeCone",
        &[
            real_of("radius1"),
            real_of("radius2"),
            real_of("height"),
            AT,
            UP,
            TURN,
        ],
        "A cone or frustum.",
    ),
    makes(
        "Solid.makeSphere",
        &[
            real_of("radius"),
            AT,
            UP,
            real("angleDegrees1", 0.0),
            real("angleDegrees2", 90.0),
            real("angleDegrees3", 360.0),
        ],
        "A sphere; with CadQuery's defaults its upper half.",
    ),
    makes(
        "Solid.makeTorus",
        &[real_of("radius1"), real_of("radius2"), AT, UP],
        "A torus.",
    ),
    makes(
        "Edge.makeLine",
        &[required("v1", Kind::Vector), required("v2", Kind::Vector)],
        "A line.",
    ),
    makes(
        "Edge.makeThreePointArc",
        &[
            required("v1", Kind::Vector),
            required("v2", Kind::Vector),
            required("v3", Kind::Vector),
        ],
        "An arc through three points.",
    ),
    makes(
        "Edge.makeCircle",
        &[
            real_of("radius"),
            AT,
            UP,
            real("angle1", 360.0),
            real("angle2", 360.0),
        ],
        "A circle or an arc of one.",
    ),
    makes(
        "Edge.makeSpline",
        &[required("listOfVector", Kind::Vectors)],
        "A smooth curve through points.",
    ),
    makes(
        "Wire.makePolygon",
        &[
            required("listOfVertices", Kind::Vectors),
            flag("forConstruction", false),
            flag("close", false),
        ],
        "Lines through points.",
    ),
    makes(
        "Wire.makeCircle",
        &[
            real_of("radius"),
            required("center", Kind::Vector),
            required("normal", Kind::Vector),
        ],
        "A circle.",
    ),
    makes(
        "Wire.makeHelix",
        &[
            real_of("pitch"),
            real_of("height"),
            real_of("radius"),
            vector("center", [0.0; 3]),
            vector("dir", [0.0, 0.0, 1.0]),
            real("angle", 360.0),
            flag("lefthand", false),
        ],
        "A helix; angle is half the angle of its cone, 360 for a cylinder.",
    ),
    makes(
        "Wire.assembleEdges",
        &[required("listOfEdges", Kind::Solids)],
        "Edges joined into one wire.",
    ),
    makes(
        "Compound.makeCompound",
        &[required("listOfShapes", Kind::Solids)],
        "Several shapes as one.",
    ),
    on(
        "Shape.moved",
        &[required("loc", Kind::Location)],
        "Moved by a location.",
    ),
    on(
        "Shape.located",
        &[required("loc", Kind::Location)],
        "Put at a location.",
    ),
    on(
        "Shape.translate",
        &[required("vector", Kind::Vector)],
        "Moved.",
    ),
    on(
        "Shape.rotate",
        &[
            required("startVector", Kind::Vector),
            required("endVector", Kind::Vector),
            real_of("angleDegrees"),
        ],
        "Turned about an axis.",
    ),
    on(
        "Shape.mirror",
        &[
            Param {
                name: "mirrorPlane",
                kind: Kind::MirrorPlane,
                default: Default::Text("XY"),
            },
            vector("basePointVector", [0.0; 3]),
        ],
        "The mirror image.",
    ),
    on(
        "Shape.fuse",
        &[
            required("toFuse", Kind::Solids),
            flag("glue", false),
            optional("tol", Kind::Real),
        ],
        "Both as one.",
    ),
    on(
        "Shape.cut",
        &[required("toCut", Kind::Solids), optional("tol", Kind::Real)],
        "Without another shape.",
    ),
    on(
        "Shape.intersect",
        &[
            required("toIntersect", Kind::Solids),
            optional("tol", Kind::Real),
        ],
        "What both have in common.",
    ),
    on("Shape.clean", &[], "Faces of one surface joined."),
];
