# each() over rotated locations with a lambda that moves a solid.
import cadquery as cq

tooth = cq.Workplane("XY").rect(8, 4).extrude(6).val()
teeth = cq.Workplane("XY").polarArray(20, 0, 360, 8).each(lambda loc: tooth.moved(loc), combine=False)
result = cq.Workplane("XY").circle(19).extrude(6).union(teeth.combine())
