# Boxes that are not combined stay separate solids on the stack.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .rarray(20, 15, 3, 2)
    .box(10, 8, 5, combine=False)
)
