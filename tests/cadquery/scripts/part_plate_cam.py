# A disc cam of a periodic spline with hub and keyway.
import cadquery as cq
import math

pts = []
for i in range(24):
    a = math.radians(15 * i)
    lift = 20 + 6 * (1 - math.cos(a)) / 2
    pts.append((lift * math.cos(a), lift * math.sin(a)))
cam = cq.Workplane("XY").spline(pts, periodic=True).close().extrude(8)
result = (
    cam.faces(">Z")
    .workplane()
    .circle(12)
    .extrude(6)
    .faces(">Z")
    .workplane()
    .hole(10)
    .faces(">Z")
    .workplane()
    .center(0, 5)
    .rect(3, 3.6)
    .cutThruAll()
)
