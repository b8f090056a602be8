# A boss extruded into the negative direction of a side face.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .box(30, 30, 10)
    .faces("<Z")
    .workplane(offset=-10)
    .circle(6)
    .extrude(-8)
)
