"""Runs every script of scripts/ through CadQuery and records what it builds.

    golden.py                 writes golden.json beside this file
    golden.py --check         recomputes and compares with golden.json; exits 1 naming differences
    golden.py NAME [NAME ..]  prints the records of the named scripts and writes nothing
    golden.py --brep FILE ..  prints the records of shapes in OCCT's BREP format, by file name
"""

import json
import math
import sys
import time
import warnings
from multiprocessing import Pool
from pathlib import Path

import cadquery as cq
import OCP
from OCP.Bnd import Bnd_Box
from OCP.BRep import BRep_Tool
from OCP.BRepBndLib import BRepBndLib

from integrals import over_shape

HERE = Path(__file__).resolve().parent
SCRIPTS = HERE / "scripts"
GOLDEN = HERE / "golden.json"

# The relative tolerance of --check.
CHECK = 1e-9


def result_of(path):
    """The shape a script shows: all shapes of `result`, a compound where there are several."""
    shown = []
    names = {
        "__name__": "__main__",
        "show_object": lambda thing, *a, **k: shown.append(thing),
    }
    exec(compile(path.read_text(encoding="utf-8"), str(path), "exec"), names)
    if "result" in names:
        shown = [names["result"]]
    shapes = []
    for thing in shown:
        values = thing.vals() if isinstance(thing, cq.Workplane) else [thing]
        shapes += [value for value in values if isinstance(value, cq.Shape)]
    if not shapes:
        raise ValueError("no shape in the result")
    return shapes[0] if len(shapes) == 1 else cq.Compound.makeCompound(shapes)


def bounds(shape):
    """The box of the exact geometry: no triangulation, no tolerance."""
    box = Bnd_Box()
    BRepBndLib.AddOptimal_s(shape.wrapped, box, False, False)
    x0, y0, z0, x1, y1, z1 = box.Get()
    return [x0, y0, z0], [x1, y1, z1]


def measure(shape):
    low, high = bounds(shape)
    volume, area, centre = over_shape(shape, low, high)
    size = math.dist(low, high)

    def snap(values):
        # What is zero but for rounding is written as zero.
        return [0.0 if abs(v) < 1e-12 * size else v for v in values]

    shells = shape.Shells()
    return {
        "solids": len(shape.Solids()),
        "faces": len(shape.Faces()),
        "edges": len(shape.Edges()),
        "vertices": len(shape.Vertices()),
        "volume": volume,
        "area": area,
        "center": snap(centre),
        "min": snap(low),
        "max": snap(high),
        "valid": shape.isValid(),
        "closed": bool(shells) and all(BRep_Tool.IsClosed_s(s.wrapped) for s in shells),
    }


def run(name):
    """One script: its record, its error, the seconds it took."""
    warnings.simplefilter("ignore")
    start = time.time()
    try:
        record, error = measure(result_of(SCRIPTS / (name + ".py"))), None
    except Exception as failure:  # the script is named with whatever it raised
        record, error = None, "%s: %s" % (type(failure).__name__, failure)
    return name, record, error, time.time() - start


def complaints(name, record):
    """What every script owes: valid, closed, positive, one solid unless it says several."""
    found = []
    if not record["valid"]:
        found.append("not valid")
    if not record["closed"]:
        found.append("not closed")
    size = math.dist(record["min"], record["max"])
    if record["volume"] < 1e-6 * size * size * size:
        found.append("volume %r" % record["volume"])
    several = name.startswith("multi_")
    if several != (record["solids"] > 1):
        found.append("%d solids" % record["solids"])
    return found


def differences(old, new):
    size = math.dist(old["min"], old["max"])
    scale = {"volume": abs(old["volume"]), "area": old["area"]}
    found = []
    for key in sorted(set(old) | set(new)):
        a, b = old.get(key), new.get(key)
        if key in ("volume", "area"):
            same = abs(a - b) <= CHECK * scale[key]
        elif key in ("center", "min", "max"):
            same = all(abs(x - y) <= CHECK * size for x, y in zip(a, b))
        else:
            same = a == b
        if not same:
            found.append("%s %r, recorded %r" % (key, b, a))
    return found


def main(arguments):
    if arguments[:1] == ["--brep"]:
        shapes = {p: cq.Shape.importBrep(p) for p in arguments[1:]}
        records = {Path(p).stem: measure(shape) for p, shape in shapes.items()}
        print(json.dumps(records, indent=1, sort_keys=True))
        return 0
    check = "--check" in arguments
    chosen = [a for a in arguments if not a.startswith("--")]
    names = chosen or sorted(p.stem for p in SCRIPTS.glob("*.py"))
    with Pool() as pool:
        answers = pool.map(run, names, chunksize=1)
    records, faults = {}, []
    for name, record, error, seconds in answers:
        if error:
            faults.append("%s: %s" % (name, error))
            continue
        records[name] = record
        faults += ["%s: %s" % (name, what) for what in complaints(name, record)]
        if seconds > 10:
            print("%s took %.0f s" % (name, seconds), file=sys.stderr)
    made = {"cadquery": cq.__version__, "ocp": OCP.__version__, "scripts": records}
    if chosen:
        print(json.dumps(records, indent=1, sort_keys=True))
    elif check:
        golden = json.loads(GOLDEN.read_text(encoding="utf-8"))
        for key in ("cadquery", "ocp"):
            if golden[key] != made[key]:
                faults.append("%s %s, recorded %s" % (key, made[key], golden[key]))
        kept = golden["scripts"]
        for name in sorted(set(kept) | set(names)):
            if name not in kept:
                faults.append("%s: not recorded" % name)
            elif name not in names:
                faults.append("%s: recorded, without a script" % name)
            elif name in records:
                faults += ["%s: %s" % (name, what) for what in differences(kept[name], records[name])]
    elif not faults:
        GOLDEN.write_text(json.dumps(made, indent=1, sort_keys=True) + "\n", encoding="utf-8")
    for fault in faults:
        print(fault, file=sys.stderr)
    if not (check or chosen) and faults:
        print("golden.json is left as it was", file=sys.stderr)
    print("%d scripts, %d faults" % (len(names), len(faults)), file=sys.stderr)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
