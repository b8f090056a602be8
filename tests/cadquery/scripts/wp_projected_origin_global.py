# The origin of the first plane is projected onto each selected face.
import cadquery as cq

result = (
    cq.Workplane("XY", origin=(10, 5, 0))
    .box(40, 20, 10, centered=False)
    .faces(">Z")
    .workplane()
    .moveTo(6, 6)
    .hole(5)
    .faces(">X")
    .workplane()
    .moveTo(4, 5)
    .hole(3, 8)
)
