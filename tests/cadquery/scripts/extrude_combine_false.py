# An extrusion that is not combined: only the new solid is the result.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .box(40, 30, 8)
    .faces(">Z")
    .workplane()
    .ellipse(10, 6)
    .extrude(5, combine=False)
)
