# A drawer handle swept over two rounded corners, drilled from below.
import cadquery as cq

path = (
    cq.Workplane("XZ")
    .moveTo(-48, 0)
    .vLine(20)
    .tangentArcPoint((8, 8))
    .hLine(80)
    .tangentArcPoint((8, -8))
    .vLine(-20)
)
bar = cq.Workplane("XY", origin=(-48, 0, 0)).ellipse(5, 4).sweep(path)
result = bar.faces("<Z").workplane(origin=(0, 0, 0)).pushPoints([(-48, 0), (48, 0)]).hole(3.3, 12)
