# The upper edges of a box chamfered.
import cadquery as cq

result = cq.Workplane("XY").box(30, 20, 10).faces(">Z").edges().chamfer(1.5)
