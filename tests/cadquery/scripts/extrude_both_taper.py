# Extrusion to both sides, and a tapered one on top.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .rect(30, 20)
    .extrude(5, both=True)
    .faces(">Z")
    .workplane()
    .rect(16, 10)
    .extrude(8, taper=12)
)
