# The compound direction names XY, XZ and YZ.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .box(30, 30, 30)
    .edges(">XY")
    .chamfer(4)
    .edges("<YZ")
    .chamfer(3)
    .edges(">XZ")
    .fillet(3)
)
