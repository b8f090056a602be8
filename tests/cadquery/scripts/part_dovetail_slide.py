# A dovetail slide: male rail with clearance reliefs.
import cadquery as cq

base = cq.Workplane("XY").box(80, 50, 10, centered=(True, True, False))
rail = cq.Workplane("YZ", origin=(-40, 0, 10)).polyline([(-10, 0), (10, 0), (15, 9), (-15, 9)]).close().extrude(80)
relief = cq.Workplane("YZ", origin=(-40, 0, 10)).pushPoints([(-10, 0), (10, 0)]).circle(1).extrude(80)
result = base.union(rail).cut(relief).faces("<Z").workplane().rarray(60, 30, 2, 2).cskHole(4.5, 9, 90, 14)
