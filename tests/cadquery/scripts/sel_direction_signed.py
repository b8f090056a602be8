# Directed faces: +Z, -X, and the bare axis name.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .box(30, 20, 12)
    .faces("+Z")
    .workplane()
    .hole(4, 5)
    .faces("-X")
    .workplane(centerOption="CenterOfMass")
    .rect(6, 4)
    .extrude(5)
    .faces("Y")
    .faces(">Y")
    .edges("|Z")
    .chamfer(1)
)
