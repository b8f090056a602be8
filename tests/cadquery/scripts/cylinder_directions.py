# Cylinders along x and y, one of them uncentred.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .cylinder(40, 6, direct=cq.Vector(1, 0, 0))
    .cylinder(30, 5, cq.Vector(0, 1, 0), centered=(True, True, False))
)
