# A wedge about another direction.
import cadquery as cq

result = cq.Workplane("XY").wedge(14, 10, 18, 3, 4, 10, 12, dir=(0, 1, 0), centered=(False, False, True))
