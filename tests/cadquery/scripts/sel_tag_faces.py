# faces(tag=...) and workplaneFromTagged after more work.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .box(40, 40, 10)
    .tag("base")
    .faces(">Z")
    .workplane()
    .tag("top_plane")
    .circle(8)
    .extrude(10)
    .faces(">X", tag="base")
    .workplane(centerOption="CenterOfMass")
    .hole(4)
    .workplaneFromTagged("top_plane")
    .rect(30, 30, forConstruction=True)
    .vertices()
    .hole(3)
)
