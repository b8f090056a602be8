# Split by another workplane's solid.
import cadquery as cq

block = cq.Workplane("XY").box(30, 20, 10)
rod = cq.Workplane("XZ").circle(3).extrude(20, both=True)
result = block.split(rod)
