# The section of a solid, its faces extruded as a gauge.
import cadquery as cq

body = cq.Workplane("XY").sphere(15).faces().end().copyWorkplane(cq.Workplane("XY"))
cut = cq.Workplane("XY").add(body.section(5).faces().wires()).toPending().extrude(4, combine=False)
result = cut
