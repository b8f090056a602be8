# An ellipse cut through all.
import cadquery as cq

result = cq.Workplane("XY").box(40, 30, 8).faces(">Z").workplane().ellipse(12, 8).cutThruAll()
