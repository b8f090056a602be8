# A shell outwards with sharp corners.
import cadquery as cq

result = cq.Workplane("XY").polygon(6, 30).extrude(15).faces("<Z").shell(2, kind="intersection")
