# An enclosure: rounded box, hollowed, with four screw posts.
import cadquery as cq

w = 80.0
d = 50.0
h = 25.0
t = 2.0
body = cq.Workplane("XY").rect(w, d).extrude(h).edges("|Z").fillet(6).faces(">Z").shell(-t)
posts = (
    cq.Workplane("XY", origin=(0, 0, t))
    .rect(w - 14, d - 14, forConstruction=True)
    .vertices()
    .circle(4)
    .circle(1.25)
    .extrude(h - t - 3)
)
result = body.union(posts)
