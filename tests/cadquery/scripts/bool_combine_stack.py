# Solids on the stack fused by combine().
import cadquery as cq

result = (
    cq.Workplane("XY")
    .pushPoints([(-6, 0), (0, 4), (6, 0)])
    .cylinder(10, 5, combine=False)
    .combine(glue=False, tol=1e-5)
)
