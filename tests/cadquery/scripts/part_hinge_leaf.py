# A hinge leaf with three knuckles about the pin.
import cadquery as cq

leaf = cq.Workplane("XY").box(60, 30, 3, centered=(True, False, False))
result = leaf
for i in [0, 2, 4]:
    x = -30 + 12 * i
    knuckle = cq.Workplane("YZ", origin=(x, 0, 3)).circle(5).extrude(12)
    result = result.union(knuckle)
for i in [1, 3]:
    x = -30 + 12 * i
    clear = cq.Workplane("YZ", origin=(x - 0.2, 0, 3)).circle(5.5).extrude(12.4)
    result = result.cut(clear)
pin = cq.Workplane("YZ", origin=(-40, 0, 3)).circle(2).extrude(80)
result = result.cut(pin).faces("<Z").workplane(origin=(0, 20, 0)).pushPoints([(-20, 0), (0, 0), (20, 0)]).cskHole(4, 7, 90)
