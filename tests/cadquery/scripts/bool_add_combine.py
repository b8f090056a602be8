# Shapes of several workplanes added to one stack and combined.
import cadquery as cq

a = cq.Workplane("XY").box(20, 10, 5)
b = cq.Workplane("XZ").circle(4).extrude(12)
c = cq.Workplane("YZ").rect(6, 12).extrude(12)
result = cq.Workplane("XY").add(a).add(b.val()).add(c.vals()).combine()
