# Cleaning put off: extrude and union with clean=False, then clean().
import cadquery as cq

result = (
    cq.Workplane("XY")
    .rect(20, 20)
    .extrude(5)
    .faces(">Z")
    .workplane()
    .rect(20, 20)
    .extrude(5, clean=False)
    .union(cq.Workplane("XY", origin=(20, 0, 0)).box(20, 20, 10, centered=(True, True, False)), clean=False)
    .clean()
    .faces(">Z")
    .edges()
    .chamfer(1)
)
