# A quarter ellipse about the current point, rotated, as a closed sector.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .ellipseArc(18, 9, 0, 90, rotation_angle=20, startAtCurrent=False)
    .lineTo(0, 0)
    .close()
    .extrude(4)
)
