# and, or with the usual precedence.
import cadquery as cq

result = cq.Workplane("XY").box(30, 20, 12).edges("|Z and >X or |X and >Z").chamfer(1.5)
