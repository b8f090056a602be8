# Faces by type: %PLANE, %Cylinder, %CONE.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .circle(12)
    .extrude(20)
    .faces(">Z")
    .chamfer(3)
    .faces("%CONE")
    .edges("<Z")
    .fillet(1)
    .faces("%PLANE and <Z")
    .workplane()
    .hole(6, 10)
    .faces("%Cylinder")
    .edges("<Z")
    .chamfer(0.5)
)
