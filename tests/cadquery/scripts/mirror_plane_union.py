# Mirrored over a named plane, united with the original.
import cadquery as cq

half = cq.Workplane("XY").polyline([(0, 0), (25, 0), (20, 10), (6, 12), (0, 18)]).close().extrude(5)
result = half.mirror("YZ", union=True)
