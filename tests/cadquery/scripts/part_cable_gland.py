# A cable gland body: hexagon, taper thread stub and clamping cone.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .polygon(6, 24, circumscribed=True)
    .extrude(8)
    .faces(">Z")
    .workplane()
    .circle(10)
    .extrude(10)
    .faces(">Z")
    .workplane()
    .circle(9)
    .extrude(5, taper=25)
    .faces("<Z")
    .workplane()
    .circle(9)
    .extrude(8)
    .faces("<Z")
    .workplane()
    .hole(10)
)
