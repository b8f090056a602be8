# A closed spline and a Bezier curve made wires at once.
import cadquery as cq

a = cq.Workplane("XY").spline([(12, 0), (0, 10), (-12, 0), (0, -8)], periodic=True, makeWire=True).extrude(4)
b = cq.Workplane("XY", origin=(0, 0, 3)).bezier([(0, 0), (14, 0), (14, 14), (0, 14), (0, 0)], makeWire=True).extrude(6)
result = a.union(b)
