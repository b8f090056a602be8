# Outer wires with inner wires of their own, fused through a base.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .box(60, 24, 4)
    .faces(">Z")
    .workplane()
    .pushPoints([(-18, 0), (18, 0)])
    .circle(9)
    .circle(5)
    .extrude(10)
)
