# A wheel hub: revolved section, lug holes and a splined bore of an array of cuts.
import cadquery as cq

section = [(10, 0), (40, 0), (40, 8), (22, 8), (18, 30), (10, 30)]
hub = cq.Workplane("XZ").polyline(section).close().revolve(360, (0, 0), (0, 1))
hub = hub.faces("<Z").workplane().polarArray(31, 0, 360, 5).cskHole(6, 10, 60)
splines = cq.Workplane("XY").polarArray(10, 0, 360, 8).rect(4, 2.5).extrude(30)
result = hub.cut(splines).edges(cq.selectors.RadiusNthSelector(-1)).fillet(1.5)
