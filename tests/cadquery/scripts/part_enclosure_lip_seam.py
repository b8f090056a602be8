# The lip of a case seam as the documentation of AreaNthSelector shows it.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .rect(20, 20)
    .extrude(10)
    .edges("|Z or <Z")
    .fillet(2)
    .faces(">Z")
    .shell(2)
    .faces(">Z")
    .wires(cq.selectors.AreaNthSelector(-1))
    .toPending()
    .workplane()
    .offset2D(-1)
    .extrude(1)
    .faces(">Z[-2]")
    .wires(cq.selectors.AreaNthSelector(0))
    .toPending()
    .workplane()
    .cutBlind(2)
)
