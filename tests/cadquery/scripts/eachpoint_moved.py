# eachpoint with a lambda that moves a shape, cutting it from the base.
import cadquery as cq

tool = cq.Workplane("XY").polygon(3, 8).extrude(4, both=True).val()
result = (
    cq.Workplane("XY")
    .box(60, 30, 6)
    .faces(">Z")
    .workplane()
    .pushPoints([(-20, 5), (0, -4), (20, 5)])
    .eachpoint(lambda loc: tool.moved(loc), True, combine="cut")
)
