# A rectangular array that begins at the origin in x and is centred in y.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .box(70, 30, 6, centered=(False, True, False))
    .faces(">Z")
    .workplane(origin=(8, 0, 0))
    .rarray(18, 14, 4, 2, center=(False, True))
    .rect(8, 6)
    .cutBlind(-4)
)
