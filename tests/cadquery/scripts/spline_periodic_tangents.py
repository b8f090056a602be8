# A periodic spline with its tangents given, on another plane.
import cadquery as cq

pts = [(10, 0), (0, 8), (-10, 0), (0, -8)]
tangents = [(0, 1), (-1, 0), (0, -1), (1, 0)]
result = cq.Workplane("XZ", origin=(1, 2, 3)).spline(pts, tangents=tangents, periodic=True).close().extrude(3)
