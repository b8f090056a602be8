# A vector direction with an index: <(0,0,1)[0] and >(-1,0,0)[1].
import cadquery as cq

result = (
    cq.Workplane("XY")
    .box(40, 20, 6)
    .faces(">Z")
    .workplane()
    .rect(20, 10)
    .extrude(6)
    .faces("<(0,0,1)[0]")
    .edges()
    .chamfer(1)
    .faces(">(-1.0, 0.0, 0.0)[1]")
    .workplane(centerOption="CenterOfMass")
    .circle(2)
    .cutBlind(-4)
)
