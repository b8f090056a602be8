# A rectangle offset outwards with arcs at the corners.
import cadquery as cq

result = cq.Workplane("XY").rect(30, 20).offset2D(4).extrude(5)
