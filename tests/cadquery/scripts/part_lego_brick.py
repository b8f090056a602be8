# The brick of the CadQuery examples: studs on top, tubes beneath.
import cadquery as cq

lbumps = 4
wbumps = 2
pitch = 8.0
clearance = 0.1
t = (pitch - (2 * clearance) - 4.8) / 2.0
postDiam = 6.51
total_length = lbumps * pitch - 2.0 * clearance
total_width = wbumps * pitch - 2.0 * clearance
s = cq.Workplane("XY").box(total_length, total_width, 9.6)
s = s.faces("<Z").shell(-1.0 * t)
s = s.faces(">Z").workplane().rarray(pitch, pitch, lbumps, wbumps, True).circle(2.4).extrude(1.8)
tmp = s.faces("<Z").workplane(invert=True)
result = tmp.rarray(pitch, pitch, lbumps - 1, wbumps - 1, center=True).circle(postDiam / 2.0).circle(2.4).extrude(9.6 - t)
