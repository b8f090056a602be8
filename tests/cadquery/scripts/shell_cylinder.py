# A cup: a cylinder hollowed from its top.
import cadquery as cq

result = cq.Workplane("XY").circle(12).extrude(30).faces(">Z").shell(-1.2)
