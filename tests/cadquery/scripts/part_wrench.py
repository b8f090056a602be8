# An open ended wrench: heads, handle, angled jaw and a recess in the handle.
import cadquery as cq

head = cq.Workplane("XY").circle(16).extrude(7)
handle = cq.Workplane("XY", origin=(50, 0, 0)).rect(90, 14).extrude(7)
eye = cq.Workplane("XY", origin=(100, 0, 0)).circle(13).extrude(7)
jaw = cq.Workplane("XY").transformed(rotate=(0, 0, 15), offset=(-8, 0, 0)).rect(24, 14).extrude(7)
hexagon = cq.Workplane("XY", origin=(100, 0, 0)).polygon(6, 14, circumscribed=True).extrude(7)
result = head.union(handle).union(eye).cut(jaw).cut(hexagon)
result = result.faces(">Z").workplane(origin=(50, 0, 0)).slot2D(50, 7).cutBlind(-1.5)
