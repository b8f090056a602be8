# NearestToPointSelector for a vertex and an edge.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .box(40, 30, 10)
    .edges(cq.selectors.NearestToPointSelector((20, 0, 5)))
    .chamfer(2)
    .edges(cq.NearestToPointSelector((-20, 15, 0)))
    .fillet(5)
)
