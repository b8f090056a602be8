# Workplane imported by name.
from cadquery import Workplane

body = Workplane("XY").rect(24, 24).extrude(10)
result = body.faces(">Z").workplane().circle(8).cutBlind(-6).edges("|Z").chamfer(2)
