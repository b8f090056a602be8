# A chain built in a for loop with conditions.
import cadquery as cq

result = cq.Workplane("XY").box(100, 20, 6)
for i in range(5):
    at = result.faces(">Z").workplane(origin=(-40 + 20 * i, 0, 0))
    if i % 2 == 0:
        result = at.hole(6 + i)
    else:
        result = at.rect(8, 4 + i).cutBlind(-3)
