# A vise jaw with V grooves and counterbored holes.
import cadquery as cq

jaw = cq.Workplane("XY").box(100, 16, 35)
v = cq.Workplane("XY", origin=(0, -8, -20)).polyline([(-4, 0), (0, 4), (4, 0)]).close().extrude(40)
h = cq.Workplane("YZ", origin=(-60, -8, 4)).polyline([(0, -3), (3, 0), (0, 3)]).close().extrude(120)
result = jaw.cut(v).cut(h).faces(">Y").workplane(origin=(0, 0, -6)).pushPoints([(-30, 0), (30, 0)]).cboreHole(8.5, 14, 9)
