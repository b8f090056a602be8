# A closed hollow: no face is removed.
import cadquery as cq

result = cq.Workplane("XY").box(30, 20, 12).shell(-2)
