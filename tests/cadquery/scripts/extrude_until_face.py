# A rod extruded until a face given as a shape.
import cadquery as cq

frame = cq.Workplane("XY").rect(50, 30).rect(40, 20).extrude(10)
target = frame.faces("<X[0]").val()
result = frame.copyWorkplane(cq.Workplane("YZ", origin=(-22, 0, 5))).rect(6, 4).extrude(target)
