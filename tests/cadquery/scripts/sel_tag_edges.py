# edges and vertices of a tagged object.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .box(30, 30, 6)
    .tag("plate")
    .faces(">Z")
    .workplane()
    .circle(5)
    .extrude(8)
    .edges("|Z", tag="plate")
    .fillet(4)
    .faces(">Z")
    .edges()
    .chamfer(0.7)
)
