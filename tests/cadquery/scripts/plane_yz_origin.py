# A plane by name with an origin.
import cadquery as cq

result = cq.Workplane("YZ", origin=(10, 20, 30)).rect(8, 14).extrude(6).faces("<X").workplane().hole(3)
