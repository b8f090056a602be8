# A blind cut in the positive direction, from a plane inside.
import cadquery as cq

result = cq.Workplane("XY").box(40, 30, 20).workplane().circle(8).cutBlind(15)
