# Selector objects joined by operators: &, +, - and unary minus.
import cadquery as cq
from cadquery import selectors

upright = selectors.ParallelDirSelector(cq.Vector(0, 0, 1))
right = selectors.DirectionMinMaxSelector(cq.Vector(1, 0, 0), True)
body = cq.Workplane("XY").box(30, 20, 12).edges(upright & right).fillet(3)
result = body.faces(selectors.StringSyntaxSelector(">Z") + selectors.StringSyntaxSelector("<Z")).faces(">Z").edges("<X").chamfer(1)
