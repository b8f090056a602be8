# Planes by their constructors with an origin each.
import cadquery as cq

base = cq.Workplane(cq.Plane.XY(origin=(0, 0, -5))).rect(30, 30).extrude(5)
fin = cq.Workplane(cq.Plane.named("XZ", origin=(0, 2, 0))).rect(20, 24).extrude(4)
result = base.union(fin)
