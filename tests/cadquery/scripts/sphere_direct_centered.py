# A sphere about another axis, part of it, set on its corner.
import cadquery as cq

result = cq.Workplane("XY").sphere(12, direct=(1, 0, 0), angle3=200, centered=(False, True, False))
