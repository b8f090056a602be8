# A swept rod with rounded corners.
import cadquery as cq

path = cq.Workplane("XZ").polyline([(0, 0), (0, 25), (30, 25)])
result = cq.Workplane("XY").circle(4).sweep(path, transition="round")
