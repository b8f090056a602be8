# A wall hanger with keyhole slots and a raised rim.
import cadquery as cq

plate = cq.Workplane("XY").rect(60, 90).extrude(4).edges("|Z").fillet(8)
rim = cq.Workplane("XY", origin=(0, 0, 4)).rect(60, 90).extrude(2).edges("|Z").fillet(8)
rim = rim.cut(cq.Workplane("XY", origin=(0, 0, 4)).rect(54, 84).extrude(2).edges("|Z").fillet(5))
result = plate.union(rim)
for y in [-25, 25]:
    big = cq.Workplane("XY", origin=(0, y, 0)).circle(5).extrude(4)
    slit = cq.Workplane("XY", origin=(0, y + 6, 0)).slot2D(16, 4, 90).extrude(4)
    result = result.cut(big.union(slit))
