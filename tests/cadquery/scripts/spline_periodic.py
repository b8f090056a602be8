# A closed periodic spline.
import cadquery as cq

pts = [(20, 0), (9, 11), (0, 17), (-12, 9), (-18, 0), (-8, -12), (0, -15), (11, -10)]
result = cq.Workplane("XY").spline(pts, periodic=True).close().extrude(6)
