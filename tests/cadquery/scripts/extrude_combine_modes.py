# Extrusions that add ("a"), subtract ("s") and cut.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .box(40, 30, 8)
    .faces(">Z")
    .workplane()
    .rect(20, 10)
    .extrude(6, combine="a")
    .faces("<Z")
    .workplane()
    .rect(30, 6)
    .extrude(-3, combine="s")
    .faces(">X")
    .workplane(centerOption="CenterOfMass")
    .circle(2)
    .extrude(-10, combine="cut")
)
