# A ratchet wheel of one sided teeth with polar lines.
import cadquery as cq
import math

n = 12
w = cq.Workplane("XY").moveTo(20, 0)
for i in range(n):
    a = 360.0 * i / n
    b = math.radians(360.0 * (i + 1) / n)
    w = w.polarLineTo(25, a + 4).lineTo(20 * math.cos(b), 20 * math.sin(b))
result = w.wire().extrude(5).faces(">Z").workplane().polygon(4, 14).cutThruAll()
