# Split by a workplane, the top kept.
import cadquery as cq

c = cq.Workplane("XY").box(10, 10, 10).faces(">Z").workplane().circle(2.5).cutThruAll()
result = c.faces(">Y").workplane(-5).split(keepTop=True)
