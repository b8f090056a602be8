# The operators + - * on workplanes.
import cadquery as cq

plate = cq.Workplane("XY").box(40, 40, 8)
boss = cq.Workplane("XY").circle(10).extrude(14)
bore = cq.Workplane("XY").circle(5).extrude(30, both=True)
limit = cq.Workplane("XY").circle(24).extrude(20, both=True)
result = (plate + boss - bore) * limit
