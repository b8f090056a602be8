# A crank: two bosses joined by a tapering web.
import cadquery as cq
import math

c = 60.0
R = 16.0
r = 10.0
a = math.acos((R - r) / c)
web = (
    cq.Workplane("XY")
    .moveTo(R * math.cos(a), R * math.sin(a))
    .lineTo(c + r * math.cos(a), r * math.sin(a))
    .threePointArc((c + r, 0), (c + r * math.cos(a), -r * math.sin(a)))
    .lineTo(R * math.cos(a), -R * math.sin(a))
    .threePointArc((-R, 0), (R * math.cos(a), R * math.sin(a)))
    .close()
    .extrude(8)
)
result = web.union(cq.Workplane("XY").circle(R - 2).extrude(20)).union(cq.Workplane("XY", origin=(c, 0, 0)).circle(r - 2).extrude(-14))
result = result.faces(">Z").workplane(origin=(0, 0, 0)).hole(14)
result = result.cut(cq.Workplane("XY").center(0, 7).rect(4, 5).extrude(20))
