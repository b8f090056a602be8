# Directions as vectors: >(1,1,0) and |(0,1,1).
import cadquery as cq

roof = cq.Workplane("YZ").polyline([(0, 0), (20, 0), (10, 10)]).close().extrude(30)
result = roof.edges("|(0,1,1)").chamfer(1).edges(">(1, 1, 0)").edges(">Z").chamfer(0.4)
