# cut and intersect with fuzzy tolerances.
import cadquery as cq

disc = cq.Workplane("XY").circle(15).extrude(10)
slab = cq.Workplane("XY", origin=(0, 0, 2)).rect(50, 12).extrude(6)
result = disc.cut(slab, tol=1e-4).intersect(cq.Workplane("XY").rect(26, 40).extrude(30), tol=1e-4)
