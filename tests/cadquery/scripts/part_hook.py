# A hook: a rod swept along a line and arcs, with an eye.
import cadquery as cq

path = cq.Workplane("XZ").vLine(-20).threePointArc((15, -35), (30, -20)).vLine(6)
rod = cq.Workplane("XY").circle(4).sweep(path)
eye = cq.Workplane("XZ", origin=(0, 5, 8)).circle(10).circle(5).extrude(10)
result = rod.union(eye)
