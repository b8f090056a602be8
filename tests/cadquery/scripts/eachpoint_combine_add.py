# eachpoint in local coordinates, fused to the base with "a".
import cadquery as cq

base = cq.Workplane("XY", origin=(0, 0, 10)).box(60, 30, 6)
pin = cq.Workplane("XY").circle(3).extrude(9).val()
result = base.faces(">Z").workplane().pushPoints([(-20, 0), (0, 5), (20, 0)]).eachpoint(lambda loc: pin.moved(loc), True, combine="a")
