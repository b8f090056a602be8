# A rope sheave with a round groove, lightening holes and a keyed hub.
import cadquery as cq

wheel = (
    cq.Workplane("XY")
    .circle(40)
    .extrude(7, both=True)
    .faces(">Z")
    .workplane()
    .circle(14)
    .extrude(4)
    .faces("<Z")
    .workplane()
    .circle(14)
    .extrude(4)
)
groove = cq.Workplane("XZ").moveTo(40, 0).circle(5).revolve(360, (0, 0), (0, 1))
result = wheel.cut(groove).faces(">Z").workplane().hole(12)
result = result.copyWorkplane(cq.Workplane("XY")).polarArray(25, 0, 360, 6).circle(5).cutThruAll()
result = result.copyWorkplane(cq.Workplane("XY")).center(6, 0).rect(5, 4).cutThruAll()
