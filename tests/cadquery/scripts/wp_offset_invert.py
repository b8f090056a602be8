# workplane with an offset and with invert.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .box(40, 30, 10)
    .faces(">Z")
    .workplane(offset=-4)
    .rect(20, 10)
    .extrude(10)
    .faces("<Z")
    .workplane(invert=True)
    .center(12, 8)
    .circle(3)
    .cutBlind(6)
)
