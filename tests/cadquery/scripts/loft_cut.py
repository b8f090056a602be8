# A funnel cut out of a block by a loft.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .box(40, 40, 20)
    .faces(">Z")
    .workplane()
    .rect(24, 16)
    .workplane(offset=-15)
    .rect(10, 6)
    .loft(ruled=True, combine="cut")
)
