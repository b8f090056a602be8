# A valve stem: cone, square and grooves from several revolved cuts.
import cadquery as cq

stem = cq.Workplane("XY").cylinder(60, 6, centered=(True, True, False))
tip = cq.Workplane("XZ").polyline([(0.5, 0), (7, 0), (7, 18), (6, 18)]).close().revolve()
result = stem.cut(tip)
for z in [28, 34]:
    result = result.cut(cq.Workplane("XZ").moveTo(6, z).circle(1.2).revolve(360, (0, 0), (0, 1)))
square = cq.Workplane("XY", origin=(0, 0, 48)).rect(20, 20).rect(8, 8).extrude(12)
result = result.cut(square)
