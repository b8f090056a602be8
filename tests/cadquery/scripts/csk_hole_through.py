# Countersunk through holes.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .box(60, 30, 8)
    .faces(">Z")
    .workplane()
    .rarray(40, 1, 2, 1)
    .cskHole(4.5, 9, 82)
)
