# A bracket of two plates with a triangular gusset.
import cadquery as cq

base = cq.Workplane("XY").box(60, 40, 6, centered=(False, True, False))
wall = cq.Workplane("XY").box(6, 40, 50, centered=(False, True, False))
gusset = cq.Workplane("XZ", origin=(0, 2.5, 0)).polyline([(6, 6), (50, 6), (6, 45)]).close().extrude(5)
result = base.union(wall).union(gusset)
result = result.faces("<Z").workplane(origin=(45, 0, 0)).rarray(1, 26, 1, 2).hole(5.5)
result = result.faces("<X").workplane(origin=(0, 0, 38)).pushPoints([(-13, 0), (13, 0)]).hole(5.5)
