# Edges parallel to an axis: |Y and |X.
import cadquery as cq

result = cq.Workplane("XY").box(30, 40, 20).edges("|Y").fillet(3).edges("|X").chamfer(0.8)
