# not before a simple selector and before a group.
import cadquery as cq

result = (
    cq.Workplane("XY")
    .box(30, 20, 12)
    .edges("not (|Z or <Z)")
    .fillet(1.5)
    .faces("not >Z and %PLANE")
    .faces("<Z")
    .edges()
    .chamfer(1)
)
