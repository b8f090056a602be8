# Mirrored over a plane given by its normal.
import cadquery as cq

arm = cq.Workplane("XY").center(14, 6).rect(24, 8).extrude(6)
result = arm.union(cq.Workplane("XY").circle(10).extrude(6)).mirror((1, 1, 0), (0, 0, 0), union=True)
