# RadiusNthSelector picks the smallest and the largest circles.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .circle(20)
    .extrude(6)
    .faces(">Z")
    .workplane()
    .circle(10)
    .extrude(6)
    .faces(">Z")
    .workplane()
    .hole(8)
    .edges(cq.selectors.RadiusNthSelector(0))
    .chamfer(0.5)
    .edges(cq.selectors.RadiusNthSelector(-1))
    .chamfer(1)
)
