# A rectangle swept along a line, turned by an auxiliary spine.
import cadquery as cq

path = cq.Workplane("XZ").lineTo(0, 40)
aux = cq.Workplane("XZ", origin=(10, 0, 0)).lineTo(6, 40)
result = cq.Workplane("XY").rect(8, 4).sweep(path, auxSpine=aux)
