# A hole in a side face, at the centre of mass and at a corner of it.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .box(40, 30, 20, centered=False)
    .faces(">Y")
    .workplane(centerOption="CenterOfMass")
    .hole(8)
    .faces(">X")
    .workplane()
    .moveTo(8, 8)
    .hole(5, 10)
)
