# A rod extruded until the last face of a frame.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .rect(50, 30)
    .rect(40, 20)
    .extrude(10)
    .copyWorkplane(cq.Workplane("YZ", origin=(-20, 0, 5)))
    .circle(2)
    .extrude("last")
)
