# cutThruAll cuts to both sides of a plane inside the solid, two outlines at once.
import cadquery as cq

result = cq.Workplane("XY").box(40, 30, 20).pushPoints([(-10, 0), (10, 4)]).slot2D(12, 6, 45).cutThruAll()
