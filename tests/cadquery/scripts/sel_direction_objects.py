# DirectionMinMaxSelector, ParallelDirSelector, PerpendicularDirSelector, TypeSelector.
import cadquery as cq

top = cq.selectors.DirectionMinMaxSelector(cq.Vector(0, 0, 1), True)
upright = cq.selectors.ParallelDirSelector(cq.Vector(0, 0, 1))
level = cq.selectors.PerpendicularDirSelector(cq.Vector(0, 0, 1))
result = (
    cq.Workplane("XY")
    .box(30, 20, 12)
    .edges(upright)
    .fillet(3)
    .faces(top)
    .edges(cq.selectors.TypeSelector("LINE"))
    .edges(level)
    .edges("<X")
    .chamfer(0.8)
)
