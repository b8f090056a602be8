# A thumb screw with a knurl of notches and a slotted top.
import cadquery as cq

head = cq.Workplane("XY").circle(9).extrude(6)
notch = cq.Workplane("XY").polarArray(9.2, 0, 360, 18).polygon(4, 1.8).extrude(6)
head = head.cut(notch)
result = (
    head.faces(">Z")
    .workplane()
    .rect(20, 1.6)
    .cutBlind(-1.5)
    .faces("<Z")
    .workplane()
    .circle(6)
    .extrude(2)
    .faces("<Z")
    .workplane()
    .circle(2.5)
    .extrude(14)
    .faces("<Z")
    .chamfer(0.5)
)
