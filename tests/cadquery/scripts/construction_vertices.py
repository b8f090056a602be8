# Counterbored holes on the corners of a construction rectangle.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .box(50, 40, 10)
    .faces(">Z")
    .workplane()
    .rect(38, 28, forConstruction=True)
    .vertices()
    .cboreHole(3.4, 6.5, 3.5)
)
