# An impeller: twisted blades on a conical hub.
import cadquery as cq

hub = cq.Workplane("XY").circle(14).extrude(24, taper=10)
result = hub.union(cq.Workplane("XY").circle(34).extrude(3))
blade = cq.Workplane("XY", origin=(0, 0, 1)).center(20, 0).rect(24, 2).twistExtrude(14, 20)
for i in range(7):
    result = result.union(blade.rotate((0, 0, 0), (0, 0, 1), i * 360 / 7))
result = result.faces("<Z").workplane().hole(6)
