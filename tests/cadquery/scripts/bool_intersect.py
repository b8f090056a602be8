# A cube and a ball in common, with the corners cut by a cylinder.
import cadquery as cq

cube = cq.Workplane("XY").box(20, 20, 20)
result = cube.intersect(cq.Workplane("XY").sphere(13)).intersect(cq.Workplane("XY").cylinder(30, 12.5), clean=False)
