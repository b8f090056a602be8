# eachpoint with a Workplane placed on every point.
import cadquery as cq

stud = cq.Workplane("XY").circle(3).extrude(5).faces(">Z").chamfer(0.5)
base = cq.Workplane("XY").box(50, 30, 6)
studs = base.faces(">Z").workplane().rarray(20, 15, 2, 2).eachpoint(stud, useLocalCoordinates=True)
result = base.union(studs)
