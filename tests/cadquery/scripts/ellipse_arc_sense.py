# Elliptic arcs the other way round and as a wire of its own.
import cadquery as cq

half = cq.Workplane("XY").moveTo(12, 0).ellipseArc(12, 7, 0, 180, sense=-1).close().extrude(4)
full = cq.Workplane("XY", origin=(24, 2, 2)).ellipseArc(8, 14, 0, 360, startAtCurrent=False, makeWire=True).extrude(6)
result = half.union(full)
