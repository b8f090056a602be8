# #(1,1,0), +(0,0,1) and -(1,0,0) with decimal components.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .polygon(4, 40)
    .extrude(10)
    .edges("#(1,1,0)")
    .edges(">Z")
    .chamfer(1.5)
    .faces("+(0,0,1)")
    .workplane()
    .hole(6)
    .faces("-(0.5,0.5,0)")
    .workplane(centerOption="CenterOfMass")
    .hole(3, 6)
)
