# A rectangle swept along a spline.
import cadquery as cq

path = cq.Workplane("XZ").spline([(0, 0), (2, 15), (8, 30), (20, 42)], tangents=[(0, 1), (1, 1)])
result = cq.Workplane("XY").rect(6, 4).sweep(path)
