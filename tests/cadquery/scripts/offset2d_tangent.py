# An offset with tangent joins.
import cadquery as cq

result = cq.Workplane("XY").polygon(4, 24).offset2D(2, "tangent").extrude(4)
