# A peg on every named plane, twelve names in one loop.
import cadquery as cq

names = ["XY", "YZ", "ZX", "XZ", "YX", "ZY"]
views = ["front", "back", "left", "right", "top", "bottom"]
result = cq.Workplane("XY").box(10, 10, 10)
for i, name in enumerate(names + views):
    peg = cq.Workplane(name).center(0.3 * i - 1, 0.2 * i).rect(1 + 0.1 * i, 2).extrude(9 + i)
    result = result.union(peg)
