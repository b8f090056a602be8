# Two closed outlines that do not touch make two solids.
import cadquery as cq

result = cq.Workplane("XY").pushPoints([(-15, 0), (15, 0)]).rect(12, 20).extrude(7)
