# A channel with rounded roots and a row of slots in its web.
import cadquery as cq

channel = (
    cq.Workplane("YZ")
    .polyline([(-20, 0), (20, 0), (20, 25), (17, 25), (17, 3), (-17, 3), (-17, 25), (-20, 25)])
    .close()
    .extrude(120)
)
channel = channel.edges("|X and <Z").fillet(4).edges(cq.selectors.BoxSelector((-1, -17.5, 2), (121, 17.5, 4))).edges("|X").fillet(2)
result = channel.faces("<Z").workplane(origin=(60, 0, 0)).rarray(30, 1, 4, 1).slot2D(16, 6).cutThruAll()
