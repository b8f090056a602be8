# A pipe tee: outside cylinders united, inside cylinders cut.
import cadquery as cq

run = cq.Workplane("YZ").circle(12).extrude(40, both=True)
branch = cq.Workplane("XY").circle(9).extrude(35)
bore = cq.Workplane("YZ").circle(10).extrude(50, both=True)
small = cq.Workplane("XY").circle(7).extrude(40)
result = (run + branch) - bore - small
