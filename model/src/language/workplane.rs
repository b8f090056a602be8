//! The methods of `Workplane`: CadQuery's.

use super::{
    Default, Kind, Method, Param, Type, centered, combine, count, flag, optional, real, required,
    text, vector,
};

const SHAPES: Kind = Kind::Choice(&[
    "Vertex",
    "Edge",
    "Wire",
    "Face",
    "Shell",
    "Solid",
    "CompSolid",
    "Compound",
]);
const CONSTRUCTION: Param = flag("forConstruction", false);
const CLEAN: Param = flag("clean", true);
const TOLERANCE: Param = optional("tol", Kind::Real);
const SELECTOR: Param = optional("selector", Kind::Selector);
const TAG: Param = optional("tag", Kind::Text);
const END_POINT: Param = required("endPoint", Kind::Vector);
const ANGLE: Param = required("angleDegrees", Kind::Real);
const DEPTH: Param = optional("depth", Kind::Real);
const INCLUDE_CURRENT: Param = flag("includeCurrent", false);
const MAKE_WIRE: Param = flag("makeWire", false);
const POINTS: Param = required("listOfXYTuple", Kind::Vectors);
const UP: Param = vector("direct", [0.0, 0.0, 1.0]);
const BOTH: Param = flag("both", false);

const fn on(name: &'static str, params: &'static [Param], doc: &'static str) -> Method {
    Method {
        name,
        on: Some(Type::Workplane),
        params,
        gives: Type::Workplane,
        doc,
    }
}

const fn gives(
    name: &'static str,
    gives: Type,
    params: &'static [Param],
    doc: &'static str,
) -> Method {
    Method {
        name,
        on: Some(Type::Workplane),
        params,
        gives,
        doc,
    }
}

const fn real_of(name: &'static str) -> Param {
    required(name, Kind::Real)
}

pub(super) static METHODS: &[Method] = &[
    Method {
        name: "Workplane",
        on: None,
        params: &[
            Param {
                name: "inPlane",
                kind: Kind::PlaneOrShape,
                default: Default::Text("XY"),
            },
            vector("origin", [0.0; 3]),
            optional("obj", Kind::Solid),
        ],
        gives: Type::Workplane,
        doc: "A new chain on a plane: XY, YZ, ZX, XZ, YX, ZY, front, back, left, right, top, bottom, a cq.Plane, or a shape.",
    },
    // Planes and the chain.
    on(
        "Workplane.workplane",
        &[
            real("offset", 0.0),
            flag("invert", false),
            text(
                "centerOption",
                Kind::Choice(&["CenterOfMass", "ProjectedOrigin", "CenterOfBoundBox"]),
                "ProjectedOrigin",
            ),
            optional("origin", Kind::Vector),
        ],
        "A plane on the selected face (or through the selected vertex), z along its normal.",
    ),
    on(
        "Workplane.copyWorkplane",
        &[required("obj", Kind::Workplane)],
        "The plane of another chain.",
    ),
    on(
        "Workplane.workplaneFromTagged",
        &[required("name", Kind::Text)],
        "The plane of a tagged place of the chain.",
    ),
    on(
        "Workplane.transformed",
        &[vector("rotate", [0.0; 3]), vector("offset", [0.0; 3])],
        "The plane moved in its own directions and turned about them, in degrees.",
    ),
    on(
        "Workplane.center",
        &[real_of("x"), real_of("y")],
        "The plane's origin moved in the plane.",
    ),
    on(
        "Workplane.tag",
        &[required("name", Kind::Text)],
        "A name for this place of the chain.",
    ),
    on(
        "Workplane.end",
        &[count("n", 1)],
        "n steps back in the chain.",
    ),
    on("Workplane.first", &[], "The first object of the stack."),
    on("Workplane.last", &[], "The last object of the stack."),
    on(
        "Workplane.item",
        &[required("i", Kind::Count)],
        "One object of the stack, counted from 0.",
    ),
    on(
        "Workplane.add",
        &[required("obj", Kind::Solids)],
        "More objects on the stack.",
    ),
    on(
        "Workplane.newObject",
        &[required("objlist", Kind::Solids)],
        "Other objects on the stack.",
    ),
    gives(
        "Workplane.val",
        Type::Shape,
        &[],
        "The first object of the stack.",
    ),
    gives(
        "Workplane.vals",
        Type::Shapes,
        &[],
        "The objects of the stack.",
    ),
    gives(
        "Workplane.findSolid",
        Type::Shape,
        &[flag("searchStack", true), flag("searchParents", true)],
        "The solid of the chain.",
    ),
    // Selection.
    on(
        "Workplane.faces",
        &[SELECTOR, TAG],
        "The faces that a selector means.",
    ),
    on("Workplane.edges", &[SELECTOR, TAG], "The edges."),
    on("Workplane.vertices", &[SELECTOR, TAG], "The vertices."),
    on("Workplane.wires", &[SELECTOR, TAG], "The wires."),
    on("Workplane.shells", &[SELECTOR, TAG], "The shells."),
    on("Workplane.solids", &[SELECTOR, TAG], "The solids."),
    on("Workplane.compounds", &[SELECTOR, TAG], "The compounds."),
    on(
        "Workplane.ancestors",
        &[required("kind", SHAPES), TAG],
        "What holds the objects of the stack.",
    ),
    on(
        "Workplane.siblings",
        &[required("kind", SHAPES), count("level", 1), TAG],
        "What shares a border of this kind with the objects of the stack.",
    ),
    // Points.
    on(
        "Workplane.pushPoints",
        &[required("pntList", Kind::Places)],
        "Points in the plane.",
    ),
    on(
        "Workplane.rarray",
        &[
            real_of("xSpacing"),
            real_of("ySpacing"),
            required("xCount", Kind::Count),
            required("yCount", Kind::Count),
            Param {
                name: "center",
                kind: Kind::Flags2,
                default: Default::Flag(true),
            },
        ],
        "Points in rows and columns.",
    ),
    on(
        "Workplane.polarArray",
        &[
            real_of("radius"),
            real_of("startAngle"),
            real_of("angle"),
            required("count", Kind::Count),
            flag("fill", true),
            flag("rotate", true),
        ],
        "Points on a circle.",
    ),
    // Drawing.
    on(
        "Workplane.moveTo",
        &[real("x", 0.0), real("y", 0.0)],
        "The current point, in the plane.",
    ),
    on(
        "Workplane.move",
        &[real("xDist", 0.0), real("yDist", 0.0)],
        "The current point moved.",
    ),
    on(
        "Workplane.lineTo",
        &[real_of("x"), real_of("y"), CONSTRUCTION],
        "A line to a point.",
    ),
    on(
        "Workplane.line",
        &[real_of("xDist"), real_of("yDist"), CONSTRUCTION],
        "A line by an offset.",
    ),
    on(
        "Workplane.hLine",
        &[real_of("distance"), CONSTRUCTION],
        "A line along x.",
    ),
    on(
        "Workplane.vLine",
        &[real_of("distance"), CONSTRUCTION],
        "A line along y.",
    ),
    on(
        "Workplane.hLineTo",
        &[real_of("xCoord"), CONSTRUCTION],
        "A line along x to a coordinate.",
    ),
    on(
        "Workplane.vLineTo",
        &[real_of("yCoord"), CONSTRUCTION],
        "A line along y to a coordinate.",
    ),
    on(
        "Workplane.polarLine",
        &[real_of("distance"), real_of("angle"), CONSTRUCTION],
        "A line of a length at an angle to x.",
    ),
    on(
        "Workplane.polarLineTo",
        &[real_of("distance"), real_of("angle"), CONSTRUCTION],
        "A line to a point in polar coordinates.",
    ),
    on(
        "Workplane.polyline",
        &[POINTS, CONSTRUCTION, INCLUDE_CURRENT],
        "Lines through points.",
    ),
    on(
        "Workplane.threePointArc",
        &[
            required("point1", Kind::Vector),
            required("point2", Kind::Vector),
            CONSTRUCTION,
        ],
        "An arc through a point to a point.",
    ),
    on(
        "Workplane.sagittaArc",
        &[END_POINT, real_of("sag"), CONSTRUCTION],
        "An arc to a point by its rise.",
    ),
    on(
        "Workplane.radiusArc",
        &[END_POINT, real_of("radius"), CONSTRUCTION],
        "An arc to a point by its radius.",
    ),
    on(
        "Workplane.tangentArcPoint",
        &[
            required("endpoint", Kind::Vector),
            CONSTRUCTION,
            flag("relative", true),
        ],
        "An arc that goes on from the last edge.",
    ),
    on(
        "Workplane.spline",
        &[
            POINTS,
            optional("tangents", Kind::MaybeVectors),
            flag("periodic", false),
            optional("parameters", Kind::Reals),
            flag("scale", true),
            TOLERANCE,
            CONSTRUCTION,
            INCLUDE_CURRENT,
            MAKE_WIRE,
        ],
        "A smooth curve through points.",
    ),
    on(
        "Workplane.bezier",
        &[POINTS, CONSTRUCTION, INCLUDE_CURRENT, MAKE_WIRE],
        "A Bezier curve by its poles.",
    ),
    on(
        "Workplane.ellipseArc",
        &[
            real_of("x_radius"),
            real_of("y_radius"),
            real("angle1", 360.0),
            real("angle2", 360.0),
            real("rotation_angle", 0.0),
            count("sense", 1),
            CONSTRUCTION,
            flag("startAtCurrent", true),
            MAKE_WIRE,
        ],
        "An arc of an ellipse.",
    ),
    on(
        "Workplane.close",
        &[],
        "A line back to the first point, and the wire of it all.",
    ),
    on(
        "Workplane.wire",
        &[CONSTRUCTION],
        "The wire of the edges drawn so far.",
    ),
    on(
        "Workplane.consolidateWires",
        &[],
        "The wires of all that is drawn.",
    ),
    on(
        "Workplane.toPending",
        &[],
        "The wires and edges of the stack as if drawn.",
    ),
    on(
        "Workplane.mirrorX",
        &[],
        "What is drawn and its mirror image at the x axis.",
    ),
    on(
        "Workplane.mirrorY",
        &[],
        "What is drawn and its mirror image at the y axis.",
    ),
    on(
        "Workplane.offset2D",
        &[
            real_of("d"),
            text(
                "kind",
                Kind::Choice(&["arc", "intersection", "tangent"]),
                "arc",
            ),
            CONSTRUCTION,
        ],
        "The drawn wires at a distance.",
    ),
    // Closed outlines at every point of the stack.
    on(
        "Workplane.rect",
        &[
            real_of("xLen"),
            real_of("yLen"),
            centered(Kind::Flags2),
            CONSTRUCTION,
        ],
        "A rectangle.",
    ),
    on(
        "Workplane.circle",
        &[real_of("radius"), CONSTRUCTION],
        "A circle.",
    ),
    on(
        "Workplane.ellipse",
        &[
            real_of("x_radius"),
            real_of("y_radius"),
            real("rotation_angle", 0.0),
            CONSTRUCTION,
        ],
        "An ellipse.",
    ),
    on(
        "Workplane.polygon",
        &[
            required("nSides", Kind::Count),
            real_of("diameter"),
            CONSTRUCTION,
            flag("circumscribed", false),
        ],
        "A regular polygon, its corners on the diameter; its sides where circumscribed.",
    ),
    on(
        "Workplane.slot2D",
        &[real_of("length"), real_of("diameter"), real("angle", 0.0)],
        "A slot with round ends, of a length over all.",
    ),
    on(
        "Workplane.outline",
        &[required("outline", Kind::Outline)],
        "A closed outline of lines and arcs, such as cq.involute gives.",
    ),
    on(
        "Workplane.each",
        &[
            required("callback", Kind::PerObject),
            flag("useLocalCoordinates", false),
            combine(true),
            CLEAN,
        ],
        "What a function gives for each object of the stack.",
    ),
    on(
        "Workplane.eachpoint",
        &[
            required("arg", Kind::PerLocation),
            flag("useLocalCoordinates", false),
            combine(false),
            CLEAN,
        ],
        "A shape at each point of the stack.",
    ),
    // Solids at every point of the stack.
    on(
        "Workplane.box",
        &[
            real_of("length"),
            real_of("width"),
            real_of("height"),
            centered(Kind::Flags3),
            combine(true),
            CLEAN,
        ],
        "A box: length along x, width along y, height along z.",
    ),
    on(
        "Workplane.cylinder",
        &[
            real_of("height"),
            real_of("radius"),
            UP,
            real("angle", 360.0),
            centered(Kind::Flags3),
            combine(true),
            CLEAN,
        ],
        "A cylinder; the height comes first.",
    ),
    on(
        "Workplane.sphere",
        &[
            real_of("radius"),
            UP,
            real("angle1", -90.0),
            real("angle2", 90.0),
            real("angle3", 360.0),
            centered(Kind::Flags3),
            combine(true),
            CLEAN,
        ],
        "A sphere.",
    ),
    on(
        "Workplane.wedge",
        &[
            real_of("dx"),
            real_of("dy"),
            real_of("dz"),
            real_of("xmin"),
            real_of("zmin"),
            real_of("xmax"),
            real_of("zmax"),
            vector("pnt", [0.0; 3]),
            vector("dir", [0.0, 0.0, 1.0]),
            centered(Kind::Flags3),
            combine(true),
            CLEAN,
        ],
        "A wedge: the face at dy reaches from xmin, zmin to xmax, zmax.",
    ),
    // Solids of what is drawn.
    on(
        "Workplane.extrude",
        &[
            required("until", Kind::Until),
            combine(true),
            CLEAN,
            BOTH,
            optional("taper", Kind::Real),
        ],
        "What is drawn, moved along the plane's normal by a length or to a face.",
    ),
    on(
        "Workplane.twistExtrude",
        &[real_of("distance"), ANGLE, combine(true), CLEAN],
        "What is drawn, moved and turned.",
    ),
    on(
        "Workplane.revolve",
        &[
            real("angleDegrees", 360.0),
            optional("axisStart", Kind::Vector),
            optional("axisEnd", Kind::Vector),
            combine(true),
            CLEAN,
        ],
        "What is drawn, turned about an axis in the plane (its y axis by default).",
    ),
    on(
        "Workplane.sweep",
        &[
            required("path", Kind::Solid),
            flag("multisection", false),
            optional("sweepAlongWires", Kind::Flag),
            flag("makeSolid", true),
            flag("isFrenet", false),
            combine(true),
            CLEAN,
            text(
                "transition",
                Kind::Choice(&["right", "round", "transformed"]),
                "right",
            ),
            optional("normal", Kind::Vector),
            optional("auxSpine", Kind::Workplane),
        ],
        "What is drawn, moved along a path.",
    ),
    on(
        "Workplane.loft",
        &[flag("ruled", false), combine(true), CLEAN],
        "A solid through the drawn wires.",
    ),
    on(
        "Workplane.cutBlind",
        &[
            required("until", Kind::Until),
            CLEAN,
            BOTH,
            optional("taper", Kind::Real),
        ],
        "Cuts what is drawn; a negative length goes into the material.",
    ),
    on(
        "Workplane.cutThruAll",
        &[CLEAN, real("taper", 0.0)],
        "Cuts what is drawn through all.",
    ),
    on(
        "Workplane.hole",
        &[real_of("diameter"), DEPTH, CLEAN],
        "Holes at the points of the stack, against the plane's normal.",
    ),
    on(
        "Workplane.cboreHole",
        &[
            real_of("diameter"),
            real_of("cboreDiameter"),
            real_of("cboreDepth"),
            DEPTH,
            CLEAN,
        ],
        "Holes with a counterbore.",
    ),
    on(
        "Workplane.cskHole",
        &[
            real_of("diameter"),
            real_of("cskDiameter"),
            real_of("cskAngle"),
            DEPTH,
            CLEAN,
        ],
        "Holes with a countersink of a whole angle.",
    ),
    // The chain's solid.
    on(
        "Workplane.fillet",
        &[real_of("radius")],
        "The selected edges, rounded.",
    ),
    on(
        "Workplane.chamfer",
        &[real_of("length"), optional("length2", Kind::Real)],
        "The selected edges, bevelled.",
    ),
    on(
        "Workplane.shell",
        &[
            real_of("thickness"),
            text("kind", Kind::Choice(&["arc", "intersection"]), "arc"),
        ],
        "Hollow, open at the selected faces; a negative thickness keeps the outside.",
    ),
    on(
        "Workplane.union",
        &[
            optional("toUnion", Kind::Solids),
            CLEAN,
            flag("glue", false),
            TOLERANCE,
        ],
        "One solid of both: they overlap, share a face or are at most 0.01 mm apart.",
    ),
    on(
        "Workplane.cut",
        &[required("toCut", Kind::Solids), CLEAN, TOLERANCE],
        "Without another solid.",
    ),
    on(
        "Workplane.intersect",
        &[required("toIntersect", Kind::Solids), CLEAN, TOLERANCE],
        "What it has in common with another solid.",
    ),
    on(
        "Workplane.combine",
        &[CLEAN, flag("glue", false), TOLERANCE],
        "The objects of the stack as one.",
    ),
    on(
        "Workplane.split",
        &[
            flag("keepTop", false),
            flag("keepBottom", false),
            optional("splitter", Kind::Solid),
        ],
        "Split at the plane, or by another shape.",
    ),
    on("Workplane.clean", &[], "Faces of one surface joined."),
    on(
        "Workplane.rotate",
        &[
            required("axisStartPoint", Kind::Vector),
            required("axisEndPoint", Kind::Vector),
            ANGLE,
        ],
        "Turned about an axis in the world.",
    ),
    on(
        "Workplane.rotateAboutCenter",
        &[required("axisEndPoint", Kind::Vector), ANGLE],
        "Turned about a direction through its centre.",
    ),
    on(
        "Workplane.translate",
        &[required("vec", Kind::Vector)],
        "Moved in the world.",
    ),
    on(
        "Workplane.mirror",
        &[
            Param {
                name: "mirrorPlane",
                kind: Kind::MirrorPlane,
                default: Default::Text("XY"),
            },
            optional("basePointVector", Kind::Vector),
            flag("union", false),
        ],
        "The mirror image, with the original where union is True.",
    ),
    on(
        "Workplane.section",
        &[real("height", 0.0)],
        "The faces in which the plane cuts the solid.",
    ),
];
