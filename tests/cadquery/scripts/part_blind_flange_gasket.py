# A gasket: an oval outline by tangent arcs and lines, offset, with a bolt pattern.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .slot2D(70, 40)
    .extrude(2)
    .faces(">Z")
    .workplane()
    .slot2D(50, 20)
    .cutThruAll()
    .faces(">Z")
    .workplane()
    .pushPoints([(-15, 15), (15, 15), (-15, -15), (15, -15), (-30, 0), (30, 0)])
    .hole(4)
)
