# A tapered pocket.
import cadquery as cq

result = cq.Workplane("XY").box(40, 30, 15).faces(">Z").workplane().rect(24, 16).cutBlind(-8, taper=10)
