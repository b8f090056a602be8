# A hole cut until a face given as a shape, past a channel.
import cadquery as cq

frame = cq.Workplane("XY").box(40, 30, 20).faces(">X").workplane().rect(10, 6).cutThruAll()
target = frame.faces("<Z[1]").val()
result = frame.faces(">Z").workplane(origin=(0, 0, 0)).circle(4).cutBlind(target)
