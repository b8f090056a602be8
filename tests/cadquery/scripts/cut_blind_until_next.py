# A cut until the next face of a channel.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .box(30, 30, 30)
    .faces(">X")
    .workplane()
    .rect(10, 10)
    .cutThruAll()
    .faces(">Z")
    .workplane(origin=(0, 0, 0))
    .circle(3)
    .cutBlind("next")
)
