# A wing nut: hub and two wings mirrored.
import cadquery as cq

hub = cq.Workplane("XY").circle(7).extrude(9, taper=8)
wing = (
    cq.Workplane("XZ", origin=(0, 1.5, 0))
    .moveTo(4, 1)
    .lineTo(14, 8)
    .threePointArc((17, 13), (13, 16))
    .lineTo(4, 7)
    .close()
    .extrude(3)
)
result = hub.union(wing).union(wing.mirror("YZ")).faces("<Z").workplane().hole(5)
