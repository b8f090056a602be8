# Two closed outlines, the second after a relative move.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .rect(40, 30)
    .moveTo(-10, -5)
    .move(2, 1)
    .hLine(10)
    .vLine(8)
    .hLine(-10)
    .close()
    .extrude(5)
)
