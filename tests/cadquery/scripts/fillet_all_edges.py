# All edges of a box rounded.
import cadquery as cq

result = cq.Workplane("XY").box(30, 20, 10).edges().fillet(2)
