# A countersunk blind hole in a tilted face.
import cadquery as cq

result = (
    cq.Workplane("XZ")
    .polyline([(0, 0), (40, 0), (40, 10), (10, 30), (0, 30)])
    .close()
    .extrude(20)
    .faces(">(2,0,3)")
    .workplane(centerOption="CenterOfMass")
    .cskHole(4, 8, 90, depth=10)
)
