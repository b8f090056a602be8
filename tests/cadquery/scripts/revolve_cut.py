# A groove revolved out of a shaft.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .circle(12)
    .extrude(40)
    .copyWorkplane(cq.Workplane("XZ"))
    .center(12, 20)
    .rect(4, 3)
    .revolve(360, (-12, 0, 0), (-12, 1, 0), combine="cut")
)
