# Holes through and to a depth.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .box(50, 30, 12)
    .faces(">Z")
    .workplane()
    .pushPoints([(-15, 0), (0, 8)])
    .hole(6)
    .faces("<Z")
    .workplane()
    .pushPoints([(15, 5), (15, -5)])
    .hole(4, 8)
)
