# A circle within a circle becomes a hole.
import cadquery as cq

result = cq.Workplane("XY").circle(10).circle(6).extrude(12)
