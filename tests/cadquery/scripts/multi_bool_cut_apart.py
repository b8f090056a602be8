# A cut that parts a bar in two solids.
import cadquery as cq

result = cq.Workplane("XY").box(60, 10, 10).cut(cq.Workplane("XY").box(8, 20, 20))
