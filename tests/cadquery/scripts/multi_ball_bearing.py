# A ball bearing: two rings and the balls between them.
import cadquery as cq

rings = cq.Workplane("XZ").moveTo(12, 0).rect(5, 10).moveTo(22, 0).rect(5, 10).revolve(360, (0, 0), (0, 1))
groove = cq.Workplane("XZ").moveTo(17, 0).circle(3.9).revolve(360, (0, 0), (0, 1))
balls = cq.Workplane("XY").polarArray(17, 0, 360, 8, rotate=False).sphere(3.2, combine=False)
result = rings.cut(groove).add(balls)
