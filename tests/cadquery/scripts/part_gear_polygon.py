# A gear of trapezoidal teeth, its outline gathered by a for loop.
import cadquery as cq
from math import cos, pi, sin

teeth = 20
outer = 22.0
root = 18.0
pts = []
for i in range(teeth):
    a = 2 * pi * i / teeth
    p = 2 * pi / teeth
    for r, f in [(root, -0.30), (outer, -0.14), (outer, 0.14), (root, 0.30)]:
        pts.append((r * cos(a + f * p), r * sin(a + f * p)))
gear = cq.Workplane("XY").polyline(pts).close().extrude(8)
result = gear.faces(">Z").workplane().circle(8).extrude(4).faces(">Z").workplane().hole(8).cut(
    cq.Workplane("XY").center(0, 4).rect(2.5, 3.6).extrude(12)
)
