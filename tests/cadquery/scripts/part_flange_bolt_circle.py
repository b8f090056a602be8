# A round flange with a hub, a bore and a bolt circle.
import cadquery as cq

bolts = 8
result = (
    cq.Workplane("XY")
    .circle(50)
    .extrude(10)
    .faces(">Z")
    .workplane()
    .circle(25)
    .extrude(20)
    .faces(">Z")
    .workplane()
    .hole(30)
    .faces("<Z")
    .workplane()
    .polarArray(38, 360.0 / bolts / 2, 360, bolts)
    .hole(7)
    .edges(cq.selectors.RadiusNthSelector(-1))
    .chamfer(1)
)
