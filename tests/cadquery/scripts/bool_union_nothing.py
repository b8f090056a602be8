# union() without an argument takes the solid of the chain as it is.
import cadquery as cq

result = cq.Workplane("XY").pushPoints([(0, 0), (6, 0)]).box(10, 10, 10, combine=False).combine().union()
