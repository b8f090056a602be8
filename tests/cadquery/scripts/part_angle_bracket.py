# An L bracket with a rounded inner corner, and holes in both legs.
import cadquery as cq

leg = 50
width = 30
thick = 5
result = (
    cq.Workplane("XZ")
    .polyline([(0, 0), (leg, 0), (leg, thick), (thick, thick), (thick, leg), (0, leg)])
    .close()
    .extrude(width)
    .edges("|Y").edges(cq.selectors.NearestToPointSelector((thick, -width / 2, thick)))
    .fillet(4)
    .faces(">X").edges("|Z")
    .fillet(6)
    .faces("<Z").workplane(centerOption="CenterOfMass")
    .center(5, 0)
    .hole(6)
    .faces("<X").workplane(centerOption="CenterOfMass")
    .center(0, 6)
    .cskHole(5, 10, 90)
)
