# A knob on a neck with a bore for a D shaft.
import cadquery as cq

body = cq.Workplane("XY").circle(8).extrude(6).faces(">Z").workplane().polygon(10, 30).extrude(12)
bore = cq.Workplane("XY").circle(3).extrude(12).cut(cq.Workplane("XY").center(0, 4).rect(10, 4).extrude(12))
result = body.cut(bore).faces(">Z").edges().chamfer(1.2)
