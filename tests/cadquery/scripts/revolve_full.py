# A profile revolved fully about the local y axis through the origin.
import cadquery as cq

result = cq.Workplane("XY").center(20, 0).rect(8, 12).revolve(360, (-20, 0), (-20, 1))
