# A workplane on a tilted face: its x runs level, its y up the slope.
import cadquery as cq

roof = cq.Workplane("XZ").polyline([(0, 0), (40, 0), (40, 10), (15, 30), (0, 30)]).close().extrude(30)
result = roof.faces("%PLANE").faces(">(4,0,5)").workplane(centerOption="CenterOfMass").center(5, 3).rect(10, 4).extrude(5)
