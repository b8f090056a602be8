# A boss extruded until the next face, the inside of a tube.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .circle(20)
    .circle(16)
    .extrude(20)
    .copyWorkplane(cq.Workplane("XZ", origin=(0, -5, 10)))
    .rect(8, 6)
    .extrude("next")
)
