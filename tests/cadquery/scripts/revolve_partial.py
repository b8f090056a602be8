# A half profile revolved by 270 degrees with the default axis.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .polyline([(0, 0), (15, 0), (15, 4), (6, 4), (6, 20), (0, 20)])
    .close()
    .revolve(270)
)
