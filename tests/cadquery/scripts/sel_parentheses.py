# Nested parentheses over all the logical words.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .box(40, 30, 10)
    .edges("(|Z and (>X or <X)) exc (>X and >Y)")
    .fillet(5)
    .edges("(not(<X or >X or <Y or >Y)) or (>Z and |X)")
    .edges(">Z and >Y")
    .chamfer(1)
)
