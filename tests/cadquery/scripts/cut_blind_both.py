# A blind cut to both sides of the plane.
import cadquery as cq

result = cq.Workplane("XY").box(40, 30, 20).workplane().ellipse(8, 5).cutBlind(6, both=True)
