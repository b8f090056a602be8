# A box centred in x and y only, standing on the plane, with a second one in a corner of it.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .box(40, 30, 10, centered=(True, True, False))
    .faces(">Z")
    .workplane()
    .box(12, 8, 6, centered=(False, True, False))
)
