# A polar array whose members turn with the angle.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .circle(30)
    .extrude(5)
    .faces(">Z")
    .workplane()
    .polarArray(18, 0, 360, 6)
    .rect(12, 5)
    .cutThruAll()
)
