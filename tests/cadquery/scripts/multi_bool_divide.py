# The operator / splits a solid by another.
import cadquery as cq

block = cq.Workplane("XY").box(30, 20, 10)
knife = cq.Workplane("XY").box(10, 40, 40)
result = block / knife
