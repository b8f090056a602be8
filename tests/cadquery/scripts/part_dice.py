# A die: a cube rounded by a ball, with pips on three faces.
import cadquery as cq

die = cq.Workplane("XY").box(20, 20, 20).intersect(cq.Workplane("XY").sphere(14))
spots = {">Z": [(0, 0)], ">X": [(-4, -4), (4, 4)], ">Y": [(-5, -5), (0, 0), (5, 5)]}
result = die
for face in spots:
    result = result.faces(face).workplane(centerOption="CenterOfMass").pushPoints(spots[face]).circle(1.8).cutBlind(-1)
