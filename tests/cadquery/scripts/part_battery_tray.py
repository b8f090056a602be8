# A battery tray: an array of round pockets, rails and finger notch.
import cadquery as cq

tray = cq.Workplane("XY").box(90, 50, 20, centered=(True, True, False)).edges("|Z").fillet(5)
tray = tray.faces(">Z").workplane().rarray(20, 20, 4, 2).circle(9).cutBlind(-16)
tray = tray.faces(">Z").workplane().rarray(20, 20, 4, 2).rect(4, 4).cutThruAll()
notch = cq.Workplane("XZ", origin=(0, 30, 20)).circle(7).extrude(60)
result = tray.cut(notch)
