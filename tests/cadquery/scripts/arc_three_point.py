# A D shape closed by an arc through three points.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .moveTo(0, -10)
    .lineTo(15, -10)
    .threePointArc((25, 0), (15, 10))
    .lineTo(0, 10)
    .close()
    .extrude(6)
)
