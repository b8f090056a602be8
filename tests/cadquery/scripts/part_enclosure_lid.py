# A lid with a lip, countersunk holes in its corners and a window.
import cadquery as cq

w = 80.0
d = 50.0
lid = cq.Workplane("XY").rect(w, d).extrude(3).edges("|Z").fillet(6)
lip = (
    cq.Workplane("XY")
    .workplane(offset=-2)
    .rect(w - 4.4, d - 4.4)
    .extrude(2)
    .edges("|Z").fillet(3.8)
    .faces(">Z or <Z")
    .shell(-1.5)
)
result = (
    lid.union(lip)
    .faces(">Z").workplane()
    .rect(w - 14, d - 14, forConstruction=True)
    .vertices()
    .cskHole(2.6, 5, 90)
    .faces(">Z").workplane()
    .rect(40, 20)
    .cutThruAll()
)
