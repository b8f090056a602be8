# A square twisted by 90 degrees.
import cadquery as cq

result = cq.Workplane("XY").rect(20, 20).twistExtrude(40, 90)
