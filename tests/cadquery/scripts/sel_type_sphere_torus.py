# Faces by type where there are spheres and tori.
import cadquery as cq

body = cq.Workplane("XY").cylinder(20, 10).edges().fillet(3)
cap = cq.Workplane("XY", origin=(0, 0, 10)).sphere(5)
result = body.union(cap).faces("%SPHERE").edges("<Z").fillet(1)
