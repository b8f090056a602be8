# end() and end(n) walk back along the chain.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .box(30, 30, 10)
    .faces(">Z")
    .edges("|X")
    .end()
    .edges("|Y")
    .end(2)
    .edges("|Z")
    .fillet(3)
)
