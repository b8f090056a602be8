# first, last and item over the points of an array.
import cadquery as cq

plate = cq.Workplane("XY").box(60, 40, 5)
pts = plate.faces(">Z").workplane().rarray(20, 15, 3, 2)
result = plate
for p, d in [(pts.first(), 4), (pts.item(2), 5), (pts.item(-2), 6), (pts.last(), 7)]:
    result = result.cut(p.circle(d / 2.0).extrude(-5, combine=False))
