# A cylinder of 210 degrees standing on the plane.
import cadquery as cq

result = cq.Workplane("XY").cylinder(15, 12, angle=210, centered=(True, True, False))
