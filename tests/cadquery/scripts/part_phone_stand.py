# A phone stand: a bent profile with radii, and a cable slot.
import cadquery as cq

profile = [(0, 0), (80, 0), (80, 5), (34, 5), (60, 70), (54, 72), (26, 5), (6, 5), (6, 14), (0, 14)]
stand = cq.Workplane("XZ").polyline(profile).close().extrude(60)
stand = stand.edges("|Y and >Z").fillet(2)
slot = cq.Workplane("XY", origin=(3, -30, 0)).rect(20, 14).extrude(30)
result = stand.cut(slot).edges("|Z and >X").fillet(8)
