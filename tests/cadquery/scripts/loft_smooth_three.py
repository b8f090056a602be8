# A smooth loft through three circles.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .circle(12)
    .workplane(offset=15)
    .circle(7)
    .workplane(offset=15)
    .circle(10)
    .loft()
)
