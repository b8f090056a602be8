# Lines to absolute places: lineTo, hLineTo, vLineTo.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .lineTo(20, 0)
    .vLineTo(8)
    .hLineTo(12)
    .lineTo(6, 16)
    .hLineTo(0)
    .close()
    .extrude(4)
)
