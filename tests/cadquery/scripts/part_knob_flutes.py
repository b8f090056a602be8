# A knob with flutes around it, a domed top and a blind bore.
import cadquery as cq

knob = cq.Workplane("XY").circle(20).extrude(16).faces(">Z").edges().fillet(3)
flutes = cq.Workplane("XY").polarArray(22, 0, 360, 12).circle(4).extrude(30)
result = knob.cut(flutes).faces("<Z").workplane().hole(6, 10)
