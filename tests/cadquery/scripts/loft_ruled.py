# A ruled loft through three sections.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .rect(30, 30)
    .workplane(offset=15)
    .rect(14, 22)
    .workplane(offset=12)
    .rect(24, 10)
    .loft(ruled=True)
)
