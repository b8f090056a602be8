# Rotation about an axis given by two points.
import cadquery as cq

result = cq.Workplane("XY").box(30, 10, 5, centered=False).rotate((5, 5, 0), (5, 6, 1), 35)
