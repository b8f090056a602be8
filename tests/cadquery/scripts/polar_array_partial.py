# A partial polar array: with fill the last member stands on the end angle.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .circle(40)
    .extrude(4)
    .faces(">Z")
    .workplane()
    .polarArray(30, 20, 140, 5)
    .hole(6)
    .faces(">Z")
    .workplane()
    .polarArray(30, 200, 25, 4, fill=False)
    .slot2D(10, 4)
    .cutThruAll()
)
