# Wires of a face made pending and extruded again.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .polygon(6, 30)
    .extrude(5)
    .faces(">Z")
    .wires()
    .toPending()
    .workplane()
    .offset2D(-3)
    .extrude(6)
)
