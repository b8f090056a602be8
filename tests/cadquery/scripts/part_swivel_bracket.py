# A bracket of a base disc and an inclined plate on a transformed plane.
import cadquery as cq

base = cq.Workplane("XY").circle(30).extrude(8).faces(">Z").workplane().polarArray(22, 45, 360, 4).hole(5)
plate = (
    cq.Workplane("XY", origin=(0, 0, 4))
    .transformed(rotate=(60, 0, 0))
    .rect(24, 50, centered=(True, False))
    .extrude(6)
    .edges(">Z")
    .fillet(2)
)
result = base.union(plate)
