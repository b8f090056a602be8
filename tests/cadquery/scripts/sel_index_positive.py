# Indexed faces from a stair: >Z[1] counts the clusters from the least.
import cadquery as cq

stair = (
    cq.Workplane("XZ")
    .polyline([(0, 0), (40, 0), (40, 10), (30, 10), (30, 20), (20, 20), (20, 30), (0, 30)])
    .close()
    .extrude(20)
)
result = (
    stair.faces(">Z[1]")
    .workplane(centerOption="CenterOfMass")
    .hole(4, 5)
    .faces(">Z[2]")
    .workplane(centerOption="CenterOfMass")
    .rect(4, 8)
    .extrude(3)
)
