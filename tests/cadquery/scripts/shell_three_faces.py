# A shell with three faces open, sharp inside.
import cadquery as cq

result = cq.Workplane("XY").box(30, 30, 30).faces(">Z or >X or >Y").shell(-3, kind="intersection")
