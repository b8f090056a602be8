# A rectangle from its corner and one centred in y only.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .rect(30, 20, centered=False)
    .extrude(5)
    .faces(">Z")
    .workplane(centerOption="CenterOfBoundBox")
    .rect(10, 6, centered=(False, True))
    .extrude(4)
)
