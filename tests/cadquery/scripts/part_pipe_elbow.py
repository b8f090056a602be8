# A pipe elbow by a sweep, with a flange at each end.
import cadquery as cq

r = 30.0
path = cq.Workplane("XZ").vLine(10).radiusArc((r, 10 + r), r).hLine(10)
pipe = cq.Workplane("XY").circle(10).circle(8).sweep(path)
lower = cq.Workplane("XY").circle(16).circle(8).extrude(4)
upper = cq.Workplane("YZ", origin=(r + 6, 0, 10 + r)).circle(16).circle(8).extrude(4)
result = pipe.union(lower).union(upper)
result = result.faces("<Z").workplane().polarArray(13, 0, 360, 4).circle(1.5).cutBlind(-4)
