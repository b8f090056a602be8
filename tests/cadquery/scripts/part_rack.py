# A toothed rack by an accumulated polyline.
import cadquery as cq

pitch = 6.0
n = 10
pts = [(0, 0)]
for i in range(n):
    x = i * pitch
    pts += [(x, 8), (x + 1.2, 8), (x + 2.4, 12), (x + 3.6, 12), (x + 4.8, 8)]
pts += [(n * pitch, 8), (n * pitch, 0)]
result = cq.Workplane("XZ").polyline(pts).close().extrude(10).faces("<Y").workplane(origin=(0, 0, 4)).pushPoints([(10, 0), (50, 0)]).hole(3.5)
