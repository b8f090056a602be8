# Boxes that share a face, united with glue.
import cadquery as cq

a = cq.Workplane("XY").box(20, 20, 10)
b = cq.Workplane("XY", origin=(20, 0, 0)).box(20, 20, 10)
result = a.union(b, glue=True)
