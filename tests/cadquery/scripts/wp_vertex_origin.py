# A workplane on a vertex of a face takes the plane of the face.
import cadquery as cq

result = (
    cq.Workplane("front")
    .box(3, 2, 0.5)
    .faces(">Z")
    .vertices("<XY")
    .workplane(centerOption="CenterOfMass")
    .circle(1.0)
    .cutThruAll()
)
