# An elliptic prism, its axes turned by 30 degrees.
import cadquery as cq

result = cq.Workplane("XY").ellipse(15, 8, rotation_angle=30).extrude(6)
