# Domes cut out of a plate, half spheres not centred in z.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .box(60, 30, 10)
    .faces(">Z")
    .workplane()
    .pushPoints([(-15, 0), (15, 0)])
    .sphere(7, combine="cut")
)
