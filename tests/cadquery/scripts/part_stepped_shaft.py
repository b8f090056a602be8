# A stepped shaft from a list of diameters, chamfered, with a keyway.
import cadquery as cq

steps = [(20, 15), (26, 30), (34, 6), (26, 20), (18, 25)]
shaft = cq.Workplane("YZ")
x = 0
for d, length in steps:
    seg = cq.Workplane("YZ", origin=(x, 0, 0)).circle(d / 2.0).extrude(length)
    shaft = shaft.add(seg)
    x += length
shaft = shaft.combine().faces("<X or >X").chamfer(1)
key = cq.Workplane("XY", origin=(30, 0, 10)).slot2D(20, 6).extrude(5)
result = shaft.cut(key)
