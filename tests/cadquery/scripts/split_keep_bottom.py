# Split by an inclined workplane, the bottom kept.
import cadquery as cq

body = cq.Workplane("XY").cylinder(30, 10)
result = body.workplane(offset=4).transformed(rotate=(25, 10, 0)).split(keepBottom=True)
