# A shell inwards, two faces open.
import cadquery as cq

result = cq.Workplane("XY").box(30, 20, 12).faces(">Z or >X").shell(-1.5)
