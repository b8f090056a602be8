# A twisted slot cut out of a cylinder.
import cadquery as cq

result = cq.Workplane("XY").circle(15).extrude(20).faces("<Z").workplane(invert=True).rect(12, 4).twistExtrude(20, 45, combine="cut")
