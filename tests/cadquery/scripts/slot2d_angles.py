# Slots across a plate, one turned by 30 degrees.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .rect(80, 50)
    .extrude(6)
    .faces(">Z")
    .workplane()
    .slot2D(40, 8, 30)
    .cutThruAll()
    .faces(">Z")
    .workplane()
    .pushPoints([(-30, 0), (30, 0)])
    .slot2D(20, 6, angle=90)
    .cutBlind(-3)
)
