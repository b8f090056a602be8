# exc and except take objects away.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .box(30, 20, 12)
    .edges("|Z exc >X")
    .fillet(4)
    .edges(">Z except <X")
    .chamfer(0.8)
)
