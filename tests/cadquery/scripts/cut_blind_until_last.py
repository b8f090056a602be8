# A cut until the last face.
import cadquery as cq

result = (
    cq.Workplane("XZ")
    .polyline([(0, 0), (40, 0), (40, 30), (30, 30), (30, 10), (10, 10), (10, 30), (0, 30)])
    .close()
    .extrude(20)
    .faces("<X")
    .workplane(centerOption="CenterOfMass")
    .center(0, 5)
    .circle(3)
    .cutBlind("last")
)
