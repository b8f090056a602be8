# Arcs by sagitta, one bulging outwards and one inwards.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .lineTo(30, 0)
    .sagittaArc((30, 20), -4)
    .lineTo(0, 20)
    .sagittaArc((0, 0), 3)
    .close()
    .extrude(5)
)
