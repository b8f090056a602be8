# The ZX plane: its local x is world Z and its local y is world X.
import cadquery as cq

result = cq.Workplane("ZX").polyline([(0, 0), (30, 0), (30, 10), (0, 20)]).close().extrude(8)
