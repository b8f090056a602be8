# Mirrored over XZ through a base point; the copy alone.
import cadquery as cq

result = cq.Workplane("XY").wedge(20, 10, 15, 2, 2, 10, 8).mirror(mirrorPlane="XZ", basePointVector=(0, 12, 0))
