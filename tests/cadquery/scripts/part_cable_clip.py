# A cable clip: an open C on a foot, its lips rounded.
import cadquery as cq

ring = cq.Workplane("XZ").center(0, 8).circle(8).circle(5.5).extrude(10)
opening = cq.Workplane("XZ", origin=(0, 0, 8)).polyline([(0, 0), (7, 10), (-7, 10)]).close().extrude(10)
foot = cq.Workplane("XY", origin=(0, -5, 0)).box(40, 10, 3, centered=(True, True, False))
bore = cq.Workplane("XZ").center(0, 8).circle(5.5).extrude(10)
clip = ring.cut(opening).union(foot).cut(bore)
result = clip.faces("<Z").workplane(origin=(0, -5, 0)).pushPoints([(-15, 0), (15, 0)]).hole(3.5)
