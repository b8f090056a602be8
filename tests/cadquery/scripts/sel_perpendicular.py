# Perpendicular faces and edges: #Z.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .box(30, 20, 12)
    .faces(">Z")
    .edges("#Z")
    .fillet(2)
    .faces("#X")
    .edges("<Z and |Y")
    .chamfer(1)
)
