# Translation by a tuple and by a Vector.
import cadquery as cq

result = cq.Workplane("XY").circle(6).extrude(4).translate((10, -5, 3)).translate(cq.Vector(1, 2, 3))
