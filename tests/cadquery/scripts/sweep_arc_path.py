# A circle swept along a line, an arc and a line.
import cadquery as cq

path = cq.Workplane("XZ").lineTo(0, 20).threePointArc((5.857864376269049, 34.14213562373095), (20, 40)).lineTo(40, 40)
result = cq.Workplane("XY").circle(5).sweep(path)
