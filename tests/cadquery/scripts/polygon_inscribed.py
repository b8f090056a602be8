# A hexagon by the diameter of its circumscribed circle.
import cadquery as cq

result = cq.Workplane("XY").polygon(6, 20).extrude(8)
