# A wire of wire: a square swept along a three dimensional spline in Frenet mode.
import cadquery as cq
import math

pts = [(10 * math.cos(0.5 * i), 10 * math.sin(0.5 * i), 2.0 * i) for i in range(10)]
path = cq.Workplane("XY").spline(pts, tangents=[(0, 10, 4), (-10 * math.sin(4.5), 10 * math.cos(4.5), 4)])
result = cq.Workplane(cq.Plane(origin=(10, 0, 0), xDir=(1, 0, 0), normal=(0, 10, 4))).rect(2, 2).sweep(path, isFrenet=True)
