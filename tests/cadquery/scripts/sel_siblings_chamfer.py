# The siblings of the top face over its edges, their lower edges chamfered.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .polygon(6, 30)
    .extrude(10)
    .faces(">Z")
    .siblings("Edge")
    .edges("<Z")
    .chamfer(1)
)
