# A drill jig: plate with bushings on a bolt circle and a locating step.
import cadquery as cq

jig = cq.Workplane("XY").box(70, 70, 12).edges("|Z").chamfer(6)
jig = jig.faces("<Z").workplane().rect(50, 50).cutBlind(-3)
jig = jig.faces(">Z").workplane().polarArray(22, 45, 360, 4).circle(6).extrude(5)
result = jig.faces(">Z[-2]").workplane(origin=(0, 0, 0)).polarArray(22, 45, 360, 4).circle(3).cutThruAll()
result = result.faces(">Z[-2]").workplane(centerOption="CenterOfBoundBox").hole(10)
