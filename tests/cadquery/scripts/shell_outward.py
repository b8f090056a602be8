# A shell outwards with rounded corners, one face open.
import cadquery as cq

result = cq.Workplane("XY").box(30, 20, 12).faces("+Z").shell(2)
