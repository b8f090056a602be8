# A profile closed over a spline that begins at the current point.
import cadquery as cq

points = [(2.75, 1.5), (2.5, 1.75), (2.0, 1.5), (1.5, 1.0), (1.0, 1.25), (0.5, 1.0), (0, 1.0)]
result = (
    cq.Workplane("XY")
    .lineTo(3.0, 0)
    .lineTo(3.0, 1.0)
    .spline(points, includeCurrent=True)
    .close()
    .extrude(0.5)
)
