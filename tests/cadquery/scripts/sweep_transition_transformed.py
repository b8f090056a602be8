# A sweep around a gentle corner with the transformed transition.
import cadquery as cq

path = cq.Workplane("XZ").polyline([(0, 0), (0, 20), (12, 40)])
result = cq.Workplane("XY").rect(5, 5).sweep(path, transition="transformed")
