# Selection from selection: faces, wires, edges, vertices.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .box(40, 30, 10)
    .faces(">Z")
    .wires()
    .edges("<X")
    .vertices(">Y")
    .workplane(centerOption="CenterOfMass")
    .circle(6)
    .cutThruAll()
)
