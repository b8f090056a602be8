# Arcs by radius; the sign says the side.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .hLine(24)
    .radiusArc((24, 16), -10)
    .hLine(-24)
    .radiusArc((0, 0), 14)
    .close()
    .extrude(5)
)
