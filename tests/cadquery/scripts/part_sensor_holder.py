# A sensor holder with a split clamp and an elliptic blend profile.
import cadquery as cq

barrel = cq.Workplane("XY").circle(13).extrude(20)
ear = cq.Workplane("XY", origin=(16, 0, 0)).rect(14, 12).extrude(20)
foot = cq.Workplane("YZ", origin=(-13, 0, 0)).ellipse(18, 8).extrude(5)
body = barrel.union(ear).union(foot.translate((0, 0, 10)))
body = body.faces(">Z").workplane(origin=(0, 0, 0)).hole(18)
body = body.cut(cq.Workplane("XY", origin=(18, 0, 0)).rect(20, 2).extrude(20))
result = body.copyWorkplane(cq.Workplane("XZ", origin=(19, 0, 10))).circle(1.6).cutThruAll()
