# A hose barb: revolved teeth, a hexagon and a through bore.
import cadquery as cq

pts = [(0, 0), (4, 0)]
for i in range(4):
    z = 6.0 * i
    pts += [(4, z + 1), (5.5, z + 2), (4.2, z + 6)]
pts += [(4.2, 28), (0, 28)]
barb = cq.Workplane("XZ").polyline(pts).close().revolve()
hexagon = cq.Workplane("XY", origin=(0, 0, 26)).polygon(6, 16).extrude(8)
thread = cq.Workplane("XY", origin=(0, 0, 34)).circle(6.5).extrude(12).faces(">Z").chamfer(1)
result = barb.union(hexagon).union(thread).faces(">Z").workplane().hole(5)
