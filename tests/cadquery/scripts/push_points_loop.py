# Points computed by a comprehension; a hole on each.
import cadquery as cq
import math

pts = [(18 * math.cos(math.radians(a)), 12 * math.sin(math.radians(a))) for a in range(0, 360, 45)]
result = cq.Workplane("XY").ellipse(26, 20).extrude(5).faces(">Z").workplane().pushPoints(pts).hole(4)
