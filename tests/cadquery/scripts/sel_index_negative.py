# Indices from the end: >Z[-2] and <X[-1].
import cadquery as cq

result = (
    cq.Workplane("XY")
    .box(50, 40, 8)
    .faces(">Z")
    .workplane()
    .rect(30, 20)
    .extrude(8)
    .faces(">Z[-2]")
    .edges("%LINE")
    .edges(">X")
    .chamfer(2)
    .faces("<X[-1]")
    .workplane(centerOption="CenterOfMass")
    .hole(4, 10)
)
