# A polar array whose members keep their orientation.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .circle(30)
    .extrude(5)
    .faces(">Z")
    .workplane()
    .polarArray(18, 15, 360, 5, rotate=False)
    .rect(10, 6)
    .cutThruAll()
)
