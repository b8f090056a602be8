# A rectangle revolved about an oblique axis.
import cadquery as cq

result = cq.Workplane("XY").moveTo(30, 0).rect(6, 10).revolve(150, (0, -20, 0), (10, 20, 0))
