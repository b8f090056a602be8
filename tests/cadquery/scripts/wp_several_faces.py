# A workplane over several coplanar faces: the combined centre.
import cadquery as cq

base = (
    cq.Workplane("XY")
    .box(60, 20, 5)
    .faces(">Z")
    .workplane()
    .pushPoints([(-20, 3), (24, -2)])
    .rect(8, 8)
    .extrude(6)
)
result = base.faces(">Z").workplane(centerOption="CenterOfMass").rect(50, 3).extrude(2)
