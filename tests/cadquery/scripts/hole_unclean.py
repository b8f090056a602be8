# Holes that cross, without cleaning.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .box(30, 30, 30)
    .faces(">Z")
    .workplane(centerOption="CenterOfMass")
    .hole(10, clean=False)
    .faces(">X")
    .workplane(centerOption="CenterOfMass")
    .hole(6, 10, clean=False)
    .faces(">Z")
    .workplane(centerOption="CenterOfMass")
    .rect(24, 4)
    .cutThruAll(clean=False)
)
