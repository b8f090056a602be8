# Elliptic pockets in a plate.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .box(60, 40, 8)
    .faces(">Z")
    .workplane()
    .pushPoints([(-15, 0), (15, 0)])
    .ellipse(6, 12)
    .cutBlind(-3)
)
