# Construction polygon and circle: holes on the vertices of the one.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .circle(30)
    .extrude(5)
    .faces(">Z")
    .workplane()
    .circle(24, forConstruction=True)
    .polygon(5, 40, forConstruction=True)
    .vertices()
    .hole(5)
)
