# A T slot extrusion: four grooves cut by a rotated tool.
import cadquery as cq

slot = cq.Workplane("XY").polyline([(4, 10.1), (4, 8), (6, 8), (6, 6.5), (3, 4.2), (-3, 4.2), (-6, 6.5), (-6, 8), (-4, 8), (-4, 10.1)]).close().extrude(60)
result = cq.Workplane("XY").rect(20, 20).extrude(60).edges("|Z").fillet(1.5)
for i in range(4):
    result = result.cut(slot.rotate((0, 0, 0), (0, 0, 1), 90 * i))
result = result.faces(">Z").workplane().hole(4.2)
