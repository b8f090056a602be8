# Half a profile mirrored over the local x axis.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .hLineTo(-10)
    .vLine(6)
    .line(10, 4)
    .line(12, -4)
    .vLineTo(0)
    .mirrorX()
    .extrude(5)
)
