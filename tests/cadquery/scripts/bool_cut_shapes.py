# Cutting a Workplane and cutting a shape handed on by val().
import cadquery as cq

block = cq.Workplane("XY").box(40, 30, 20)
ball = cq.Workplane("XY", origin=(0, 0, 10)).sphere(8)
bar = cq.Workplane("XZ").rect(6, 6).extrude(40, both=True)
result = block.cut(ball).cut(bar.val(), clean=True)
