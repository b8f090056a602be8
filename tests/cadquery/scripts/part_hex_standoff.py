# A hexagonal standoff with threaded stub and tapped hole.
import cadquery as cq

across_flats = 7.0
result = (
    cq.Workplane("XY")
    .polygon(6, across_flats, circumscribed=True)
    .extrude(20)
    .faces("<Z")
    .workplane()
    .circle(2)
    .extrude(6)
    .faces("<Z")
    .chamfer(0.4)
    .faces(">Z")
    .workplane()
    .hole(3.3, 10)
)
