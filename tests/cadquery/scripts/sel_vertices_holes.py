# Holes on the vertices of a face of a smaller boss.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .box(60, 50, 6)
    .faces(">Z")
    .workplane()
    .rect(40, 30)
    .extrude(4)
    .faces(">Z")
    .vertices()
    .hole(3)
)
