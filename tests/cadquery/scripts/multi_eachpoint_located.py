# eachpoint with a lambda that locates a shape: separate solids.
import cadquery as cq

pin = cq.Workplane("XY").circle(2).extrude(10).val()
result = cq.Workplane("XY").rect(30, 20, forConstruction=True).vertices().eachpoint(lambda loc: pin.located(loc))
