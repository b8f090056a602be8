# A groove swept out of a plate: sweep with combine "cut".
import cadquery as cq

plate = cq.Workplane("XY").box(60, 40, 10, centered=(True, True, False))
path = cq.Workplane("XY", origin=(0, 0, 10)).moveTo(-20, -30).vLine(25).tangentArcPoint((20, 20)).hLine(40)
result = plate.copyWorkplane(cq.Workplane("XZ", origin=(-20, -30, 10))).circle(3).sweep(path, combine="cut")
