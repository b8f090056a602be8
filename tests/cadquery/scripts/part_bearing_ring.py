# The outer ring of a ball bearing: revolved section with a ball groove.
import cadquery as cq

ring = cq.Workplane("XZ").center(22, 0).rect(8, 14).revolve(360, (-22, 0), (-22, 1))
groove = cq.Workplane("XZ").moveTo(17, 0).circle(4.5).revolve(360, (0, 0), (0, 1))
result = ring.cut(groove).edges("%CIRCLE").edges(">Z or <Z").fillet(0.6)
