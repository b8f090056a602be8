# copyWorkplane takes the plane of another chain.
import cadquery as cq

side = cq.Workplane("YZ", origin=(20, 0, 0))
result = cq.Workplane("XY").box(40, 30, 20).copyWorkplane(side).rect(10, 8).extrude(6).copyWorkplane(cq.Workplane("XZ", origin=(0, 15, 0))).circle(4).cutBlind(10)
