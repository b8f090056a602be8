# A square swept along a spline in space in Frenet mode.
import cadquery as cq

path = cq.Workplane("XY").spline([(0, 0, 0), (14, 4, 6), (20, 16, 14)], tangents=[(1, 0, 0), (0, 1, 0.5)])
result = cq.Workplane("YZ").rect(3, 3).sweep(path, isFrenet=True)
