# A flanged bush with chamfered ends and a grease groove.
import cadquery as cq

od = 24.0
bore = 16.0
result = (
    cq.Workplane("XY")
    .circle(17)
    .extrude(4)
    .faces(">Z")
    .workplane()
    .circle(od / 2)
    .extrude(26)
    .faces("<Z")
    .workplane()
    .hole(bore)
    .faces(">Z")
    .edges("%CIRCLE")
    .chamfer(1)
)
groove = cq.Workplane("XZ").center(bore / 2, 15).rect(2, 3).revolve(360, (-bore / 2, 0), (-bore / 2, 1))
result = result.cut(groove)
