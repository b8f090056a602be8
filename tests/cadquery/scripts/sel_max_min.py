# The directional extremes >Z, <Z, >X, <Y on faces and edges.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .box(40, 30, 20)
    .faces(">Z")
    .edges("<Y")
    .chamfer(3)
    .faces(">X")
    .workplane()
    .hole(5, 6)
    .faces("<Z")
    .edges("<X")
    .fillet(2)
)
