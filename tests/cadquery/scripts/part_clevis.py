# A clevis: a fork with rounded ends, a pin hole and a tapped stem.
import cadquery as cq

fork = cq.Workplane("XZ").rect(20, 44, centered=(True, False)).extrude(12, both=True)
fork = fork.edges("|Y and >Z").fillet(9.5)
gap = cq.Workplane("XY", origin=(0, 0, 14)).rect(30, 10).extrude(40)
result = (
    fork.cut(gap)
    .faces(">Y")
    .workplane(origin=(0, 0, 34))
    .hole(8)
    .faces("<Z")
    .workplane()
    .hole(6.8, 12)
    .edges("|Z and (>X or <X)")
    .chamfer(1)
)
