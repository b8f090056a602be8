# A carrier plate with standoffs of a list of coordinates.
import cadquery as cq

points = [(3.5, 3.5), (61.5, 3.5), (61.5, 52.5), (3.5, 52.5)]
plate = cq.Workplane("XY").rect(85, 56, centered=False).extrude(2.5).edges("|Z").fillet(3)
studs = cq.Workplane("XY", origin=(0, 0, 2.5)).pushPoints(points).circle(3).circle(1.35).extrude(5)
vent = cq.Workplane("XY", origin=(32, 28, 0)).rarray(6, 1, 5, 1).slot2D(24, 3, 90).extrude(2.5)
result = plate.union(studs).cut(vent)
