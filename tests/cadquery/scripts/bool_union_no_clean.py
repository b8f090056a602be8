# The same kind of union without cleaning keeps the seams.
import cadquery as cq

a = cq.Workplane("XY").box(20, 20, 10)
b = cq.Workplane("XY").box(10, 30, 10, centered=(True, False, True))
result = a.union(b, clean=False)
