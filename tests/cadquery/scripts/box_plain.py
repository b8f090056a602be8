# A box centred on the origin.
import cadquery as cq

result = cq.Workplane("XY").box(30, 20, 10)
