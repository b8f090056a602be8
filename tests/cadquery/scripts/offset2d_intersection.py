# A polygon offset outwards with sharp corners.
import cadquery as cq

result = cq.Workplane("XY").polyline([(0, 0), (30, 0), (24, 16), (4, 14)]).close().offset2D(3, "intersection").extrude(5)
