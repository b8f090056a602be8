# The origin of the side face is carried to the top: the pocket opens at the edge.
import cadquery as cq

side = cq.Workplane("XY").box(30, 30, 30).faces(">X").workplane().rect(10, 10).cutThruAll()
result = side.faces(">Z").workplane().circle(6).cutBlind(-5)
