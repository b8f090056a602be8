# Pushed points with a height of their own.
import cadquery as cq

heights = [4 + 2 * i for i in range(4)]
points = [(15 * i - 22.5, 0, h) for i, h in enumerate(heights)]
base = cq.Workplane("XY").box(70, 20, 8)
result = base.cut(cq.Workplane("XY").pushPoints(points).cylinder(12, 5, combine=False).combine())
