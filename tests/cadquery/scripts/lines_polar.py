# Polar lines, relative and absolute.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .polarLine(20, 0)
    .polarLine(12, 75)
    .polarLineTo(22, 80)
    .polarLineTo(16, 130)
    .close()
    .extrude(6)
)
