"""The same work by CadQuery, in a process of its own; answers one line of JSON.

    peer.py joint PARTS FILE      builds the bolted joint, intersects its parts, writes a STEP file
    peer.py interference FILE     intersects the parts of a STEP file
"""

import json
import math
import os
import sys
import time

import cadquery as cq
from OCP.Bnd import Bnd_Box
from OCP.BRepBndLib import BRepBndLib

import joint as j

# Boxes nearer than this meet, in mm.
NEAR = 1e-6


def box_of(shape):
    """Not CadQuery's BoundingBox: that one takes the optimal box, which costs more than it saves."""
    box = Bnd_Box()
    BRepBndLib.Add_s(shape.wrapped, box, False)
    return box.Get()


def interference(shapes):
    """The common volumes of all pairs whose boxes meet, swept along the longest axis."""
    begun = time.perf_counter()
    boxes = [box_of(shape) for shape in shapes]
    spread = [max(box[a + 3] for box in boxes) - min(box[a] for box in boxes) for a in range(3)]
    axis = spread.index(max(spread))
    order = sorted(range(len(boxes)), key=lambda k: boxes[k][axis])
    active, pairs = [], []
    for k in order:
        active = [o for o in active if boxes[o][axis + 3] >= boxes[k][axis] - NEAR]
        for o in active:
            if all(
                boxes[o][a] <= boxes[k][a + 3] + NEAR and boxes[k][a] <= boxes[o][a + 3] + NEAR for a in range(3)
            ):
                pairs.append((o, k))
        active.append(k)
    overlaps = sum(shapes[a].intersect(shapes[b]).Volume() > 1e-3 for a, b in pairs)
    took = time.perf_counter() - begun
    return {"parts": len(shapes), "pairs": len(pairs), "overlaps": overlaps, "interference_s": took}


def solids(n):
    """Each distinct solid once."""
    r = j.circle_d(n) / 2
    bore = r - j.RIM if r > 2 * j.RIM else r / 2
    flange = cq.Workplane().circle(r + j.RIM).circle(bore).extrude(j.HEIGHT)
    flange = flange.faces(">Z").workplane().polarArray(r, 0, 360, n, rotate=False).hole(j.HOLE)
    bolt = cq.Workplane().polygon(6, j.HEAD_S, circumscribed=True).extrude(j.HEAD_K)
    bolt = bolt.faces("<Z").workplane().circle(j.D / 2).extrude(j.BOLT_L)
    nut = cq.Workplane().polygon(6, j.HEAD_S, circumscribed=True).extrude(j.NUT_M)
    nut = nut.faces("<Z").workplane().hole(j.NUT_HOLE)
    washer = cq.Workplane().circle(j.WASHER_O / 2).extrude(j.WASHER_H)
    washer = washer.faces(">Z").workplane().hole(j.WASHER_I)
    return [solid.val() for solid in (flange, bolt, nut, washer)]


def joint(parts, path):
    n = j.holes(parts)
    flange, bolt, nut, washer = solids(n)
    top = 2 * j.HEIGHT
    placed = [("lower", flange, (0, 0, 0)), ("upper", flange, (0, 0, j.HEIGHT))]
    for i in range(n):
        x, y = (j.circle_d(n) / 2 * f(2 * math.pi * i / n) for f in (math.cos, math.sin))
        placed += [
            (f"over_{i}", washer, (x, y, top)),
            (f"under_{i}", washer, (x, y, -j.WASHER_H)),
            (f"bolt_{i}", bolt, (x, y, top + j.WASHER_H)),
            (f"nut_{i}", nut, (x, y, -j.WASHER_H - j.NUT_M)),
        ]
    assembly = cq.Assembly(name="joint")
    for name, solid, at in placed:
        assembly.add(solid, name=name, loc=cq.Location(cq.Vector(*at)))
    result = interference([solid.located(cq.Location(cq.Vector(*at))) for _, solid, at in placed])
    assembly.export(path)
    return result


def main():
    what, *rest = sys.argv[1:]
    if what == "joint":
        result = joint(int(rest[0]), rest[1])
    else:
        result = interference(cq.importers.importStep(rest[0]).solids().vals())
    print(json.dumps(result), flush=True)
    # The interpreter's own end is no part of the work.
    os._exit(0)


main()
