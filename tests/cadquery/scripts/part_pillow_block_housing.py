# A bearing housing: foot, round body blended over it, slots and an oil hole.
import cadquery as cq

foot = cq.Workplane("XY").box(90, 30, 12, centered=(True, True, False)).edges("|Z").fillet(5)
body = (
    cq.Workplane("XZ", origin=(0, 14, 0))
    .moveTo(-24, 0)
    .lineTo(24, 0)
    .lineTo(24, 30)
    .threePointArc((0, 54), (-24, 30))
    .close()
    .extrude(28)
)
result = foot.union(body)
result = result.faces(">Y").workplane(origin=(0, 0, 30)).hole(26)
result = result.copyWorkplane(cq.Workplane("XY")).pushPoints([(-35, 0), (35, 0)]).slot2D(12, 7).cutThruAll()
result = result.copyWorkplane(cq.Workplane("XY", origin=(0, 0, 60))).circle(2).cutBlind(-20)
