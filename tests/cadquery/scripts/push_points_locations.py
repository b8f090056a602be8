# Locations pushed on the stack carry their own rotation.
import cadquery as cq

locs = [cq.Location(cq.Vector(15 * i - 15, 0, 0), cq.Vector(0, 0, 1), 30 * i) for i in range(3)]
result = cq.Workplane("XY").box(60, 24, 6).faces(">Z").workplane().pushPoints(locs).rect(10, 4).cutBlind(-4)
