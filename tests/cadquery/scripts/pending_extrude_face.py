# A selected face extruded as it is.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .box(30, 20, 6)
    .edges("|Z")
    .fillet(4)
    .faces(">Z")
    .wires()
    .toPending()
    .extrude(5, taper=15)
)
