# BoxSelector by centre and by bounding box.
import cadquery as cq

plate = (
    cq.Workplane("XY")
    .box(60, 20, 5)
    .faces(">Z")
    .workplane()
    .pushPoints([(-20, 0), (0, 0), (20, 0)])
    .circle(5)
    .extrude(8)
)
right = plate.edges(cq.selectors.BoxSelector((10, -8, 9), (30, 8, 12))).chamfer(1)
result = right.faces(cq.selectors.BoxSelector((-6, -6, 2), (6, 6, 11), boundingbox=True)).edges(">Z").fillet(1)
