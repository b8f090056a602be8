# A socket cap screw: head, hexagonal socket, shank.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .circle(6.5)
    .extrude(8)
    .faces(">Z")
    .edges()
    .fillet(0.8)
    .faces(">Z")
    .workplane()
    .polygon(6, 7.0)
    .cutBlind(-4)
    .faces("<Z")
    .workplane()
    .circle(4)
    .extrude(30)
    .faces("<Z")
    .edges()
    .chamfer(1)
)
