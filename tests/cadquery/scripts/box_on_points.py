# One box on each pushed point, fused to a base, without cleaning.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .box(60, 20, 4)
    .faces(">Z")
    .workplane()
    .pushPoints([(-20, 0), (0, 3), (20, -3)])
    .box(6, 6, 10, centered=(True, True, False), clean=False)
)
