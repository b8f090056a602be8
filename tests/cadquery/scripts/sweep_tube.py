# A tube: two concentric circles swept together.
import cadquery as cq

path = cq.Workplane("XZ").vLine(15).radiusArc((12, 27), 12).hLine(10)
result = cq.Workplane("XY").circle(5).circle(3.5).sweep(path)
