# The vertical edges rounded, then the edges of the top.
import cadquery as cq

result = cq.Workplane("XY").box(30, 20, 10).edges("|Z").fillet(4).faces(">Z").edges().fillet(1)
