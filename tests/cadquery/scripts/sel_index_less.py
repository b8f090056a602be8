# <X[1]: indexed from the greatest.
import cadquery as cq

comb = (
    cq.Workplane("XY")
    .box(70, 20, 5, centered=(False, True, False))
    .faces(">Z")
    .workplane(origin=(5, 0, 0))
    .rarray(15, 1, 5, 1, center=(False, True))
    .rect(6, 12)
    .extrude(15)
)
result = comb.faces("<X[1]").workplane(centerOption="CenterOfMass").circle(2.5).cutBlind(-3)
