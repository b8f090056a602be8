"""In how many scripts every method, option and selector form of the vocabulary occurs.

    coverage.py          prints the table; exits 1 where something occurs in no script, or where
                         a script uses what Starlark does not have
"""

import ast
import re
import sys
from collections import Counter
from pathlib import Path

SCRIPTS = Path(__file__).resolve().parent / "scripts"

METHODS = """
add ancestors bezier box cboreHole center chamfer circle clean close combine compounds consolidateWires
copyWorkplane cskHole cut cutBlind cutThruAll cylinder each eachpoint edges ellipse ellipseArc end
extrude faces fillet first hLine hLineTo hole intersect item last line lineTo loft mirror mirrorX
mirrorY move moveTo offset2D polarArray polarLine polarLineTo polygon polyline pushPoints radiusArc
rarray rect revolve rotate rotateAboutCenter sagittaArc section shell shells siblings slot2D solids
sphere spline split sweep tag tangentArcPoint threePointArc toPending transformed translate
twistExtrude union val vals vLine vLineTo vertices wedge wire wires workplane workplaneFromTagged
""".split()

# Named options: (method, keyword).
KEYWORDS = """
ellipseArc.sense ellipseArc.makeWire bezier.makeWire spline.makeWire extrude.clean cutThruAll.clean
hole.clean circle.forConstruction polygon.forConstruction cut.tol intersect.tol sphere.direct
sphere.centered wedge.dir twistExtrude.combine Workplane.origin bezier.includeCurrent box.centered box.clean box.combine combine.glue combine.tol
cut.clean cutBlind.both cutBlind.taper cutThruAll.taper cylinder.angle cylinder.centered
cylinder.combine cylinder.direct each.combine eachpoint.combine eachpoint.useLocalCoordinates
ellipse.rotation_angle ellipseArc.rotation_angle ellipseArc.startAtCurrent extrude.both
extrude.combine extrude.taper faces.tag edges.tag intersect.clean loft.combine loft.ruled
mirror.basePointVector mirror.union offset2D.forConstruction polarArray.fill polarArray.rotate
polygon.circumscribed polyline.includeCurrent rarray.center rect.centered rect.forConstruction
revolve.combine shell.kind sphere.angle1 sphere.angle2 sphere.angle3 sphere.combine spline.includeCurrent
spline.periodic spline.tangents split.keepBottom split.keepTop sweep.auxSpine sweep.isFrenet
sweep.combine sweep.multisection sweep.transition tangentArcPoint.relative transformed.offset transformed.rotate
union.clean union.glue union.tol wedge.centered workplane.centerOption workplane.invert
workplane.offset workplane.origin
""".split()

# Text arguments: method and value.
VALUES = """
Workplane:XY Workplane:YZ Workplane:ZX Workplane:XZ Workplane:YX Workplane:ZY Workplane:front
Workplane:back Workplane:left Workplane:right Workplane:top Workplane:bottom
extrude:next extrude:last extrude:a extrude:s extrude:cut cutBlind:next cutBlind:last
offset2D:intersection offset2D:tangent shell:intersection sweep:right sweep:round
sweep:transformed workplane:CenterOfMass workplane:ProjectedOrigin workplane:CenterOfBoundBox
mirror:XY mirror:YZ mirror:XZ
""".split()

AXIS = r"(?:[XYZ]\b)"
VECTOR = r"\([-+0-9. ]+,[-+0-9. ]+,[-+0-9. ]+\)"
SELECTORS = {
    ">Z": r"(?<!>)>" + AXIS + r"(?!\[)",
    "<Z": r"(?<!<)<" + AXIS + r"(?!\[)",
    ">Z[1]": r"(?<!>)>" + AXIS + r"\[\d",
    ">Z[-2]": r"(?<!>)>" + AXIS + r"\[-",
    "<X[1]": r"(?<!<)<" + AXIS + r"\[\d",
    "<X[-1]": r"(?<!<)<" + AXIS + r"\[-",
    ">>Z": r">>" + AXIS + r"(?!\[)",
    ">>Z[n]": r">>" + AXIS + r"\[",
    "<<Y": r"<<" + AXIS + r"(?!\[)",
    "<<Y[n]": r"<<" + AXIS + r"\[",
    "|Y": r"\|" + AXIS,
    "#Z": r"#" + AXIS,
    "+Z": r"\+" + AXIS,
    "-X": r"(?<!\[)-" + AXIS,
    "Z": r"^" + AXIS + r"$",
    ">XY": r"[<>](XY|XZ|YZ)\b",
    "%PLANE": r"(?i)%PLANE",
    "%CIRCLE": r"(?i)%CIRCLE",
    "%LINE": r"(?i)%LINE",
    "%ELLIPSE": r"(?i)%ELLIPSE",
    "%Cylinder": r"(?i)%CYLINDER",
    "%CONE": r"(?i)%CONE",
    "%SPHERE": r"(?i)%SPHERE",
    ">(x,y,z)": r">" + VECTOR,
    "<(x,y,z)[n]": r"[<>]" + VECTOR + r"\[",
    "|(x,y,z)": r"\|" + VECTOR,
    "#(x,y,z)": r"#" + VECTOR,
    "+(x,y,z)": r"\+" + VECTOR,
    "-(x,y,z)": r"-" + VECTOR,
    "front": r"^front$",
    "back": r"^back$",
    "left": r"^left$",
    "right": r"^right$",
    "top": r"^top$",
    "bottom": r"^bottom$",
    "and": r"\band\b",
    "or": r"\bor\b",
    "not": r"\bnot\b",
    "exc": r"\bexc\b",
    "except": r"\bexcept\b",
    "( )": r"\([^0-9]*\)",
}
OBJECTS = """
AreaNthSelector BoxSelector DirectionMinMaxSelector NearestToPointSelector ParallelDirSelector
PerpendicularDirSelector RadiusNthSelector StringSyntaxSelector TypeSelector
Location Plane Plane.XY Plane.named Vector moved located show_object
""".split()
OPERATORS = {
    ast.Add: "+", ast.Sub: "-", ast.Mult: "*", ast.BitOr: "|", ast.BitAnd: "&", ast.Div: "/",
}
SELECTING = "faces edges vertices wires shells solids compounds".split()

# What Starlark does not have.
FORBIDDEN = (
    ast.While, ast.Try, ast.ClassDef, ast.With, ast.JoinedStr, ast.GeneratorExp, ast.Set,
    ast.SetComp, ast.Starred, ast.Pow, ast.Is, ast.IsNot, ast.NamedExpr, ast.Global, ast.Nonlocal,
    ast.Assert, ast.Raise, ast.Delete, ast.Yield, ast.Await, ast.AnnAssign, ast.MatMult,
)
READING = "Volume Area Center BoundingBox size objects Length isValid Faces Edges Vertices".split()
ABSENT = "isinstance sum format join map filter round pow next iter set open input eval exec".split()


def fold(node):
    """The text of a constant, None otherwise."""
    return node.value if isinstance(node, ast.Constant) and isinstance(node.value, str) else None


def occurrences(tree, text):
    found = set()
    loops = {}
    for node in ast.walk(tree):
        # Names of planes gathered in lists or dictionaries count for what they are handed to.
        if isinstance(node, (ast.List, ast.Dict)):
            items = node.elts if isinstance(node, ast.List) else node.keys
            for value in [fold(i) for i in items]:
                if value:
                    loops[value] = True
    for node in ast.walk(tree):
        if isinstance(node, ast.Attribute):
            found.add("object " + node.attr)
            if isinstance(node.value, ast.Attribute):
                found.add("object " + node.value.attr + "." + node.attr)
        if isinstance(node, ast.Name):
            found.add("object " + node.id)
        if not isinstance(node, ast.Call):
            continue
        name = getattr(node.func, "attr", getattr(node.func, "id", None))
        if isinstance(node.func, ast.Attribute):
            found.add("method " + name)
        values = [fold(a) for a in node.args]
        for keyword in node.keywords:
            found.add("option %s.%s" % (name, keyword.arg))
            values.append(fold(keyword.value))
        for value in values:
            if value is not None:
                found.add("value %s:%s" % (name, value))
            if value is not None and (name in SELECTING or name == "StringSyntaxSelector"):
                for form, pattern in SELECTORS.items():
                    if re.search(pattern, value):
                        found.add("selector " + form)
        if name == "Workplane" and any(isinstance(a, ast.Name) for a in node.args):
            for value in loops:
                found.add("value Workplane:" + value)
    shapes = set()
    for node in ast.walk(tree):
        if isinstance(node, ast.Assign) and len(node.targets) == 1 and isinstance(node.value, ast.Call):
            chain = node.value
            while isinstance(chain, ast.Call) and isinstance(chain.func, ast.Attribute):
                if chain.func.attr == "Workplane" and isinstance(node.targets[0], ast.Name):
                    shapes.add(node.targets[0].id)
                chain = chain.func.value
    for node in ast.walk(tree):
        if isinstance(node, ast.BinOp) and type(node.op) in OPERATORS:
            names = {n.id for n in (node.left, node.right) if isinstance(n, ast.Name)}
            if names & shapes:
                found.add("operator " + OPERATORS[type(node.op)])
    return found


def offences(tree, text, lines):
    found = []
    for node in ast.walk(tree):
        if isinstance(node, FORBIDDEN):
            found.append(type(node).__name__)
        if isinstance(node, ast.Compare) and len(node.ops) > 1:
            found.append("chained comparison")
        if isinstance(node, ast.Assign) and len(node.targets) > 1:
            found.append("chained assignment")
        if isinstance(node, ast.AugAssign) and not isinstance(node.op, (ast.Add, ast.Sub)):
            found.append("augmented assignment")
        if isinstance(node, (ast.FunctionDef, ast.Lambda)) and getattr(node, "decorator_list", None):
            found.append("decorator")
        if isinstance(node, ast.Call):
            name = getattr(node.func, "attr", getattr(node.func, "id", None))
            if name in ABSENT:
                found.append(name)
        if isinstance(node, ast.Attribute) and node.attr in READING:
            found.append("reads ." + node.attr)
    if not text.startswith("# "):
        found.append("no comment first")
    if "result = " not in text and "show_object(" not in text:
        found.append("no result")
    return found


def main():
    wanted = (
        ["method " + m for m in METHODS]
        + ["option " + k for k in KEYWORDS]
        + ["value " + v for v in VALUES]
        + ["selector " + s for s in SELECTORS]
        + ["object " + o for o in OBJECTS]
        + ["operator " + o for o in OPERATORS.values()]
    )
    counts, faults, bodies = Counter(), [], {}
    paths = sorted(SCRIPTS.glob("*.py"))
    for path in paths:
        text = path.read_text(encoding="utf-8")
        tree = ast.parse(text, str(path))
        counts.update(occurrences(tree, text))
        faults += ["%s: %s" % (path.stem, what) for what in offences(tree, text, text.splitlines())]
        shape = re.sub(r"[-\d.]+", "0", ast.unparse(tree))
        if shape in bodies:
            faults.append("%s: differs from %s in numbers alone" % (path.stem, bodies[shape]))
        bodies[shape] = path.stem
    for name in wanted:
        print("%5d  %s" % (counts[name], name))
        if not counts[name]:
            faults.append("no script has " + name)
    for fault in faults:
        print(fault, file=sys.stderr)
    print("%d scripts, %d of %d forms covered" % (len(paths), sum(1 for n in wanted if counts[n]), len(wanted)))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
