# Boxes of three combine modes: "s", "cut" and "a".
import cadquery as cq

result = (
    cq.Workplane("XY")
    .box(40, 40, 20)
    .faces(">Z")
    .workplane()
    .box(20, 20, 12, combine="s")
    .faces(">X")
    .workplane(centerOption="CenterOfMass")
    .box(6, 8, 10, combine="cut")
    .faces("<X")
    .workplane(centerOption="CenterOfMass")
    .box(8, 8, 6, combine="a")
)
