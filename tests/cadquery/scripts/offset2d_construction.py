# Holes on the corners of an offset outline that is for construction.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .box(60, 40, 8)
    .faces(">Z")
    .wires()
    .toPending()
    .offset2D(-6, forConstruction=True)
    .vertices()
    .circle(2.5)
    .cutThruAll()
)
