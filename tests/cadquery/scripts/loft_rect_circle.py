# A loft from a rectangle to a circle.
import cadquery as cq

result = cq.Workplane("XY").rect(30, 20).workplane(offset=25).circle(8).loft(combine=True)
