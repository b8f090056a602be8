# A filament spool: core, two flanges with windows, mirrored over the middle.
import cadquery as cq

half = (
    cq.Workplane("XY")
    .circle(30)
    .extrude(25)
    .faces(">Z")
    .workplane()
    .circle(60)
    .extrude(4)
    .faces(">Z")
    .workplane()
    .polarArray(45, 0, 360, 6)
    .circle(9)
    .cutBlind(-4)
)
result = half.mirror("XY", union=True).faces(">Z").workplane().hole(40)
