# A hexagon head bolt with an unthreaded shank.
import cadquery as cq

head = cq.Workplane("XY").polygon(6, 18.475).extrude(7)
cone = cq.Workplane("XZ").polyline([(0, 0), (9.6, 0), (9.6, 5.6), (8.2, 7), (0, 7)]).close().revolve(360, (0, 0), (0, 1))
shank = cq.Workplane("XY").circle(5).extrude(-40).faces("<Z").chamfer(1)
result = head.intersect(cone).union(shank)
