# Split with both halves kept on the stack.
import cadquery as cq

result = cq.Workplane("XY").sphere(10).workplane(offset=3).split(keepTop=True, keepBottom=True)
