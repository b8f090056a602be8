# A full sphere away from the origin.
import cadquery as cq

result = cq.Workplane("XY", origin=(5, -4, 3)).sphere(9)
