# An octagon by the width across its flats, holding a pentagon pocket.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .polygon(8, 30, circumscribed=True)
    .extrude(10)
    .faces(">Z")
    .workplane()
    .polygon(5, 14)
    .cutBlind(-6)
)
