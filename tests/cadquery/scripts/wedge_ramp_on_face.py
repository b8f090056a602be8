# A centred wedge as a ramp fused to the side of a block.
import cadquery as cq

block = cq.Workplane("XY").box(30, 30, 12, centered=(True, True, False))
ramp = cq.Workplane("XZ").wedge(20, 12, 30, 0, 0, 20, 2, centered=(True, False, True))
result = block.union(ramp.translate((15, 0, 0)))
