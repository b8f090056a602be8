# A counterbored blind hole.
import cadquery as cq

result = cq.Workplane("XY").circle(15).extrude(30).faces(">Z").workplane().cboreHole(6, 12, 6, 20)
