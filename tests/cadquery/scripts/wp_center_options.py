# The three centre options on the same L shaped face.
import cadquery as cq

ell = cq.Workplane("XY").polyline([(5, 5), (45, 5), (45, 15), (20, 15), (20, 40), (5, 40)]).close().extrude(8)
result = (
    ell.faces(">Z")
    .workplane(centerOption="CenterOfMass")
    .hole(3)
    .faces("<Z")
    .workplane(centerOption="CenterOfBoundBox")
    .rect(30, 8)
    .extrude(4)
    .faces(">Z")
    .workplane(centerOption="ProjectedOrigin")
    .moveTo(10, 30)
    .hole(5)
)
