# Faces whose normal is parallel to an axis; their edges of a kind.
import cadquery as cq

result = cq.Workplane("XY").circle(20).circle(12).extrude(10).faces("|Z").edges("%CIRCLE").chamfer(1)
