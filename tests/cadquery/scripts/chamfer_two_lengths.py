# A chamfer of two lengths around a cylinder.
import cadquery as cq

result = cq.Workplane("XY").circle(12).extrude(20).edges(">Z").chamfer(3, 1)
