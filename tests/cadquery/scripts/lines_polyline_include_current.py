# A polyline that begins at the current point.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .moveTo(-10, -5)
    .polyline([(10, -5), (14, 3), (4, 9), (-8, 6)], includeCurrent=True)
    .close()
    .extrude(5)
)
