# Rotation about the centre of the object.
import cadquery as cq

result = cq.Workplane("XY", origin=(20, 10, 5)).box(30, 10, 5).rotateAboutCenter((0, 1, 1), 40)
