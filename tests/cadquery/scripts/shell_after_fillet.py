# Fillets first, then a shell inwards through them.
import cadquery as cq

result = cq.Workplane("XY").box(50, 40, 20).edges("|Z").fillet(8).edges("<Z").fillet(3).faces(">Z").shell(-1.5)
