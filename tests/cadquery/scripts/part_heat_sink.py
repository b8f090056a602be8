# A heat sink of fins made in a loop.
import cadquery as cq

fins = 9
pitch = 5.0
result = cq.Workplane("XY").box(fins * pitch, 40, 4, centered=(True, True, False))
for i in range(fins):
    x = (i - (fins - 1) / 2) * pitch
    h = 18 if i % 2 == 0 else 14
    result = result.union(cq.Workplane("XY", origin=(x, 0, 4)).rect(1.6, 40).extrude(h))
result = result.faces("<Z").workplane().rect(30, 30, forConstruction=True).vertices().hole(3, 3)
