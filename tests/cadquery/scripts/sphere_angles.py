# A spherical sector: latitudes -30 to 60, 120 degrees around.
import cadquery as cq

result = cq.Workplane("XY").sphere(20, angle1=-30, angle2=60, angle3=120)
