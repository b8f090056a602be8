# A rectangular array of holes about the centre.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .box(80, 50, 5)
    .faces(">Z")
    .workplane()
    .rarray(15, 12, 5, 4)
    .hole(5)
)
