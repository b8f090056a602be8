# Edges drawn out of order are consolidated into one wire.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .moveTo(0, 0)
    .lineTo(20, 0)
    .moveTo(20, 12)
    .lineTo(0, 12)
    .moveTo(20, 0)
    .threePointArc((24, 6), (20, 12))
    .moveTo(0, 12)
    .lineTo(0, 0)
    .consolidateWires()
    .extrude(5)
)
