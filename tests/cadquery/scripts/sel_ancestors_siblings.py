# ancestors of an edge and siblings of a face.
import cadquery as cq

body = cq.Workplane("XY").box(30, 20, 10).edges("|Z and >X and >Y").chamfer(4)
result = (
    body.faces(">(1,1,0)")
    .siblings("Edge")
    .ancestors("Face")
    .faces(">Z")
    .edges("<X")
    .chamfer(1)
)
