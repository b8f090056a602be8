# A fan guard: rings joined by spokes.
import cadquery as cq

guard = cq.Workplane("XY").rect(60, 60).circle(27).extrude(3).edges("|Z").edges("%LINE").edges(">X or <X").fillet(4)
for r in [9, 16, 23]:
    guard = guard.add(cq.Workplane("XY").circle(r + 0.9).circle(r - 0.9).extrude(3))
guard = guard.add(cq.Workplane("XY").rect(56, 2).extrude(3)).add(cq.Workplane("XY").rect(2, 56).extrude(3))
result = guard.combine().faces(">Z").workplane(origin=(0, 0, 0)).rect(50, 50, forConstruction=True).vertices().hole(3.4)
