# An elliptic arc that starts at the current point.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .moveTo(10, 0)
    .ellipseArc(10, 6, 0, 180)
    .close()
    .extrude(5)
)
