# A funnel of two outlines revolved to a thin wall, with a hanging eye.
import cadquery as cq

profile = [(35, 30), (8, 0), (6, -25), (4.5, -25), (6.5, 0), (33.2, 30)]
body = cq.Workplane("XZ").polyline(profile).close().revolve(360, (0, 0), (0, 1))
eye = cq.Workplane("XY", origin=(38, 0, 28)).circle(5).circle(2).extrude(2)
result = body.union(eye)
