# A spline with tangents at both ends.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .hLine(30)
    .vLine(10)
    .spline([(20, 14), (10, 8), (0, 10)], tangents=[(-1, 1), (-1, 0)], includeCurrent=True)
    .close()
    .extrude(5)
)
