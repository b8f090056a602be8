# A cut through all with a taper.
import cadquery as cq

result = cq.Workplane("XY").box(40, 40, 10).faces(">Z").workplane().rect(20, 20).cutThruAll(taper=5)
