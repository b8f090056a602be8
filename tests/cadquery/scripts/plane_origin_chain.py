# A workplane moved by origin on a selected face.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .box(50, 30, 10)
    .faces(">Z")
    .workplane(origin=(15, 5, 0))
    .hole(6)
    .faces("<Z")
    .workplane(origin=(-15, 5, 0))
    .hole(8, 4)
)
