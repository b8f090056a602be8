# A hydraulic manifold: crossing bores and counterbored ports on five faces.
import cadquery as cq

block = cq.Workplane("XY").box(80, 40, 30).edges().chamfer(1)
block = block.faces("<X").workplane(centerOption="CenterOfMass").hole(8, 70)
block = block.faces(">Z").workplane(centerOption="CenterOfMass").pushPoints([(-25, 0), (0, 0), (25, 0)]).cboreHole(5, 12, 9, 15)
block = block.faces(">Y").workplane(centerOption="CenterOfMass").center(12, 0).hole(6, 20)
block = block.faces("<Y").workplane(centerOption="CenterOfMass").center(-12, 0).hole(6, 20)
result = block.faces("<Z").workplane(centerOption="CenterOfMass").rarray(68, 28, 2, 2).hole(4.2, 10)
