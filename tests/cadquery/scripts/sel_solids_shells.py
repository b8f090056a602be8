# Solids, shells and compounds picked out of a stack of several.
import cadquery as cq

boxes = cq.Workplane("XY").pushPoints([(-20, 0), (20, 0), (50, 10)]).box(10, 10, 10, combine=False)
pick = boxes.solids(">X")
bar = cq.Workplane("XY", origin=(50, 10, 0)).cylinder(20, 3)
result = pick.union(bar).compounds().shells().end(2).solids()
