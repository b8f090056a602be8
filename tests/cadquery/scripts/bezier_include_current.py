# A Bezier edge from the current point.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .moveTo(5, 0)
    .hLine(20)
    .bezier([(30, 8), (18, 16), (10, 12)], includeCurrent=True)
    .close()
    .extrude(4)
)
