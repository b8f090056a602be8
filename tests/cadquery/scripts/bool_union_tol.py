# A union with a tolerance given.
import cadquery as cq

a = cq.Workplane("XY").circle(10).extrude(10)
b = cq.Workplane("XY", origin=(0, 0, 5)).rect(30, 6).extrude(10)
result = a.union(b, tol=1e-4)
