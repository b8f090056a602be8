# A twisted triangle on a disc.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .circle(20)
    .extrude(5)
    .faces(">Z")
    .workplane()
    .polygon(3, 24)
    .twistExtrude(25, -60)
)
