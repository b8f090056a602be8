# Counterbored through holes on several points.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .box(60, 40, 12)
    .faces(">Z")
    .workplane()
    .pushPoints([(-20, -10), (20, -10), (0, 12)])
    .cboreHole(5, 9, 5)
)
