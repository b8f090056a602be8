# transformed by rotations about all three local axes.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .box(30, 30, 10)
    .faces(">Z")
    .workplane()
    .transformed(rotate=(20, 30, 40))
    .circle(4)
    .extrude(20, both=True)
)
