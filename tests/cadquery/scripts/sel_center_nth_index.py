# >>Z[-3] and <<Y[0] over edges that are not straight.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .circle(15)
    .extrude(5)
    .faces(">Z")
    .workplane()
    .circle(10)
    .extrude(5)
    .faces(">Z")
    .workplane()
    .center(0, 2)
    .circle(5)
    .extrude(5)
    .edges(">>Z[-3]")
    .chamfer(0.6)
    .edges("<<Y[0]")
    .edges(">Z")
    .fillet(1)
)
