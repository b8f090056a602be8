# A picture frame swept around a rectangle with mitred corners, rebated.
import cadquery as cq

outer = cq.Workplane("XY").rect(120, 90).extrude(12).faces(">Z").edges().chamfer(4)
window = cq.Workplane("XY").rect(90, 60).extrude(12)
rebate = cq.Workplane("XY").rect(98, 68).extrude(6)
result = outer.cut(window).cut(rebate).faces(">Z").edges("%LINE").edges(cq.selectors.BoxSelector((-46, -31, 11), (46, 31, 13))).chamfer(2)
