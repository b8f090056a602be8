# A spring seat: cup with a guide, revolved, with drain holes.
import cadquery as cq

profile = [(0, 0), (22, 0), (22, 10), (19, 10), (19, 4), (10, 4), (10, 14), (8, 16), (0, 16)]
result = (
    cq.Workplane("XZ")
    .polyline(profile)
    .close()
    .revolve(360, (0, 0, 0), (0, 1, 0))
    .faces("<Z")
    .workplane()
    .polarArray(14.5, 30, 360, 6)
    .hole(3)
    .faces(">Z")
    .workplane()
    .hole(8)
)
