# Inward offsets of an outline with arcs, as a pocket.
import cadquery as cq

outline = cq.Workplane("XY").slot2D(50, 24)
pocket = cq.Workplane("XY", origin=(0, 0, 3)).slot2D(50, 24).offset2D(-3).extrude(10)
result = outline.extrude(10).cut(pocket)
