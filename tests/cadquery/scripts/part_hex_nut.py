# A nut: hexagon and chamfered cylinder in common, bored and countersunk.
import cadquery as cq
import math

s = 13.0
m = 6.5
hexagon = cq.Workplane("XY").polygon(6, s / math.cos(math.pi / 6)).extrude(m)
limit = cq.Workplane("XY").circle(s / 2 + 0.4).extrude(m).edges("%CIRCLE").chamfer(0.5, 0.9)
result = hexagon.intersect(limit).faces(">Z").workplane().cskHole(6.8, 8, 90)
