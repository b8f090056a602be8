# A mount for a NEMA 17 motor: plate, pilot bore, slots on the bolt square, feet.
import cadquery as cq

plate = (
    cq.Workplane("XY")
    .rect(50, 50)
    .extrude(5)
    .edges("|Z").fillet(4)
    .faces(">Z").workplane()
    .hole(22.5)
    .faces(">Z").workplane()
    .rect(31, 31, forConstruction=True)
    .vertices()
    .slot2D(5, 3.2, 45)
    .cutThruAll()
)
foot = (
    cq.Workplane("XZ", origin=(0, -20, 0))
    .rect(60, 30, centered=(True, False))
    .extrude(5)
    .edges("|Y and >Z").fillet(5)
    .faces("<Y").workplane(origin=(0, 0, 20))
    .pushPoints([(-20, 0), (20, 0)])
    .cboreHole(4.5, 8, 2)
)
result = plate.union(foot)
