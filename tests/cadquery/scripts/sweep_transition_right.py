# A swept frame with mitred corners.
import cadquery as cq

path = cq.Workplane("XZ").polyline([(0, 0), (0, 30), (40, 30), (40, 0)])
result = cq.Workplane("XY").rect(6, 4).sweep(path, transition="right")
