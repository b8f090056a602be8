# A cubic Bezier edge between straight ones.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .lineTo(0, 10)
    .bezier([(0, 10), (10, 20), (20, 0), (30, 10)])
    .lineTo(30, 0)
    .close()
    .extrude(5)
)
