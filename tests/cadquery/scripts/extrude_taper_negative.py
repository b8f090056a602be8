# A negative taper widens the solid upwards.
import cadquery as cq

result = cq.Workplane("XY").circle(10).extrude(8, taper=-10).faces(">Z").workplane().hole(8)
