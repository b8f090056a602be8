# A castellated nut: three turned cuts make six slots.
import cadquery as cq

nut = cq.Workplane("XY").polygon(6, 20, circumscribed=True).extrude(10).faces(">Z").workplane().circle(8.5).extrude(6)
slots = cq.Workplane("XY", origin=(0, 0, 11))
for a in [30, 90, 150]:
    nut = nut.cut(slots.transformed(rotate=(0, 0, a)).rect(24, 3).extrude(6))
result = nut.faces("<Z").workplane().cskHole(10, 13, 120)
