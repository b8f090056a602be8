# An arc tangent to the line before it, relative and absolute ends.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .lineTo(20, 0)
    .tangentArcPoint((6, 10))
    .lineTo(20, 24)
    .tangentArcPoint((6, 20), relative=False)
    .lineTo(0, 8)
    .close()
    .extrude(4)
)
