# A lever with a curved outline by arcs, two eyes and a boss on one side.
import cadquery as cq

lever = (
    cq.Workplane("XY")
    .moveTo(0, 12)
    .threePointArc((-12, 0), (0, -12))
    .sagittaArc((70, -7), 4)
    .threePointArc((77, 0), (70, 7))
    .sagittaArc((0, 12), 4)
    .close()
    .extrude(6)
)
result = (
    lever.faces(">Z").workplane()
    .circle(9)
    .extrude(5)
    .faces(">Z").workplane()
    .hole(10)
    .faces("<Z").workplane()
    .center(70, 0)
    .hole(6)
)
