# A wedge with a smaller far face, from the corner.
import cadquery as cq

result = cq.Workplane("XY").wedge(20, 10, 16, 4, 3, 14, 12, centered=False)
