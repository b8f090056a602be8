# Dimensions from a dictionary, shown by show_object.
import cadquery as cq

dims = {"length": 50, "width": 30, "thick": 5, "holes": [(-18, -9), (18, 9)]}
plate = cq.Workplane("XY").box(dims["length"], dims["width"], dims["thick"])
plate = plate.faces(">Z").workplane().pushPoints(dims["holes"]).hole(4.2)
plate = plate.edges("|Z").fillet(dims["width"] / 10)
show_object(plate)
