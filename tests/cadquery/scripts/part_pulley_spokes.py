# A pulley with a V groove and five windows between its spokes.
import cadquery as cq

profile = [(8, -12), (14, -12), (14, -5), (34, -5), (34, -8), (42, -8), (36, 0), (42, 8), (34, 8), (34, 5), (14, 5), (14, 12), (8, 12)]
wheel = cq.Workplane("XZ").polyline(profile).close().revolve(360, (0, 0), (0, 1))
window = (
    cq.Workplane("XY")
    .polarArray(24, 0, 360, 5)
    .slot2D(14, 9)
    .extrude(20, both=True)
)
result = wheel.cut(window)
