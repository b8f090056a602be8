# The foot of a boss filleted.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .box(40, 40, 6)
    .faces(">Z")
    .workplane()
    .circle(10)
    .extrude(12)
    .edges("%CIRCLE and (not >Z)")
    .fillet(3)
)
