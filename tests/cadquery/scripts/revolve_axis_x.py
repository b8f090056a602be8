# A circle revolved about the local x axis: a third of a torus on the XZ plane.
import cadquery as cq

result = cq.Workplane("XZ").moveTo(0, 25).circle(6).revolve(120, (0, 0), (1, 0))
