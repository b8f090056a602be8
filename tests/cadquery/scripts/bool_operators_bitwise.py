# The operators | & on workplanes.
import cadquery as cq

a = cq.Workplane("XY").box(30, 10, 10)
b = cq.Workplane("XY").box(10, 30, 10)
c = cq.Workplane("XY").sphere(12)
result = (a | b) & c
