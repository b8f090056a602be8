# >>Z and <<Y: the extremes by centre whatever the form of the face.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .box(30, 30, 10)
    .edges("|Z")
    .fillet(5)
    .faces(">>Z")
    .edges()
    .chamfer(1)
    .faces("<<Y")
    .workplane(centerOption="CenterOfMass")
    .hole(4, 6)
)
