# A function with default arguments builds the feet of a plate.
import cadquery as cq


def foot(x, y, h=8, d=6):
    return cq.Workplane("XY", origin=(x, y, 0)).circle(d / 2).extrude(-h).faces("<Z").chamfer(0.6)


result = cq.Workplane("XY").rect(60, 40).extrude(4)
for x, y, h in [(-24, -14, 8), (24, -14, 10), (24, 14, 8), (-24, 14, 10)]:
    result = result.union(foot(x, y, h=h))
