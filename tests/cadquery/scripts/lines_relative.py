# Relative lines: line, hLine, vLine, from a moved start.
import cadquery as cq

result = (
    cq.Workplane("XZ")
    .moveTo(5, 5)
    .hLine(20)
    .vLine(6)
    .line(-8, 5)
    .hLine(-6)
    .vLine(-3)
    .close()
    .extrude(7)
)
