# Mirrored over its own face, picked by a selector.
import cadquery as cq

half = cq.Workplane("XY").polyline([(0, 0), (30, 0), (30, 10), (12, 20), (0, 20)]).close().extrude(8)
result = half.mirror(half.faces(">X"), union=True)
