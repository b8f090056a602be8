# A clamping collar: slit, clamp screw with head recess.
import cadquery as cq

collar = cq.Workplane("XY").circle(18).circle(8).extrude(12).edges(">Z or <Z").chamfer(0.6)
collar = collar.cut(cq.Workplane("XY").center(13, 0).rect(12, 2).extrude(12))
result = collar.copyWorkplane(cq.Workplane("XZ", origin=(13, 0, 6))).circle(1.6).cutThruAll()
recess = cq.Workplane("XZ", origin=(13, -5, 6)).circle(3.2).extrude(15)
result = result.cut(recess)
