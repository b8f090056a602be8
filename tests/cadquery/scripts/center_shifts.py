# Shifting the origin twice; the second shift is relative to the first.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .box(60, 40, 6)
    .faces(">Z")
    .workplane()
    .center(-20, -10)
    .hole(5)
    .center(40, 20)
    .hole(8)
)
