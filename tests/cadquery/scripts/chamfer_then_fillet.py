# Chamfered vertical edges, then the bottom rounded.
import cadquery as cq

result = cq.Workplane("XY").box(40, 30, 12).edges("|Z").chamfer(4).faces("<Z").edges().fillet(1)
