# Sections of three sizes swept along a straight path.
import cadquery as cq

path = cq.Workplane("XZ").moveTo(-10, 0).lineTo(10, 0)
result = (
    cq.Workplane("YZ")
    .workplane(offset=-10.0)
    .circle(2.0)
    .workplane(offset=10.0)
    .circle(1.0)
    .workplane(offset=10.0)
    .circle(2.0)
    .sweep(path, multisection=True)
)
