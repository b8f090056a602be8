# A vase: a smooth loft through polygons of one kind, hollowed by a second loft.
import cadquery as cq

outer = cq.Workplane("XY").circle(20).workplane(offset=30).circle(30).workplane(offset=35).circle(14).loft()
inner = cq.Workplane("XY", origin=(0, 0, 4)).circle(16).workplane(offset=26).circle(26).workplane(offset=35).circle(10).loft()
result = outer.cut(inner)
