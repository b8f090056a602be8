# An eccentric on a shaft with a grub screw hole across.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .circle(10)
    .extrude(12)
    .faces(">Z")
    .workplane()
    .moveTo(5, 0)
    .circle(20)
    .extrude(8)
    .faces(">Z")
    .workplane()
    .moveTo(0, 0)
    .hole(10)
    .copyWorkplane(cq.Workplane("XZ", origin=(0, 0, 6)))
    .circle(1.6)
    .cutBlind(-15)
)
