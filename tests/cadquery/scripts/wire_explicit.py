# Edges gathered into a wire by wire(), then extruded.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .moveTo(0, 0)
    .lineTo(10, 0)
    .lineTo(10, 6)
    .lineTo(0, 12)
    .lineTo(0, 0)
    .wire()
    .extrude(3)
)
