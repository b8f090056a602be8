# A tapered hexagon extruded downwards.
import cadquery as cq

result = cq.Workplane("XY", origin=(0, 0, 10)).polygon(6, 30).extrude(-12, taper=8)
