# Sketching on a plane given by origin, x direction and normal.
import cadquery as cq

plane = cq.Plane(origin=(5, 5, 5), xDir=(1, 1, 0), normal=(1, -1, 1))
result = cq.Workplane(plane).rect(20, 10).extrude(5).faces(">Z").edges("<Z").chamfer(0.8)
