"""Machines that are less regular than the joint. A docstring says on the page what each one is."""

from joint import mate

PLATE, SHAFT, SPUR = "base_frame.rect_plate", "base_frame.stepped_shaft", "gear.spur"


class Machine:
    """A draft in the making; z of all axes points the same way, so that `direction` is mostly `same`."""

    def __init__(self, name, root):
        self.draft = {"assembly": {"id": name, "root": root, "parts": [], "mates": []}}

    def part(self, name, factory, **params):
        self.draft["assembly"]["parts"].append({"id": name, "factory": factory, "params": params})

    def mate(self, kind, base, incoming, axioms, **options):
        mates = self.draft["assembly"]["mates"]
        mates.append(mate(f"m{len(mates) + 1}", kind, base, incoming, axioms.split(), **options))

    def face(self, base, incoming, **options):
        self.mate("face_to_face", base, incoming, "C-01", **options)

    def axis(self, base, incoming, d, **options):
        self.mate("coaxial", base, incoming, "C-02", **{"d_mm": d, "direction": "same", **options})

    def press(self, base, incoming, d, **options):
        self.mate("press_fit", base, incoming, "C-03", **{"d_mm": d, "direction": "same", **options})

    def seat(self, base, incoming):
        self.mate("coaxial_face", base, incoming, "T-10")

    def mesh(self, base, incoming):
        self.mate("gear_mesh", f"{base}:mesh_point", f"{incoming}:mesh_point", "G-01 G-02")


def gears():
    """five gears of 48 teeth in a row, each pressed on a pin that turns in a board"""
    m = Machine("gears", "board")
    m.part("board", "bench.board", n=5, pitch=96)
    for i in range(1, 6):
        m.part(f"pin_{i}", SHAFT, segments=[{"d": 12, "length": 40}])
        m.part(f"gear_{i}", SPUR, teeth=48, backlash_mm=0.1)
    for i in range(1, 6):
        m.axis(f"board:hole_{i}", f"pin_{i}:shaft_seat_1", 0)
        # Every other one is turned by half a pitch.
        m.press(f"pin_{i}:shaft_seat_1", f"gear_{i}:bore", 17, alpha_deg=0 if i % 2 else 3.75)
        if i > 1:
            m.mesh(f"gear_{i - 1}", f"gear_{i}")
    return m.draft


def gearbox():
    """two stages of gears, keyed on three shafts, with rings beside them, in six bearings between two cheeks on a
    bolted base"""
    m = Machine("gearbox", "floor")
    base = {"length": 340, "width": 180, "thickness": 12, "bolt_d": 8, "edge": 15}
    m.part("floor", PLATE, **base)
    m.part("plate", PLATE, **base)
    m.face("floor:top_face", "plate:bottom_face")
    for i in range(1, 5):
        m.part(f"washer_{i}", "fastener.washer", d=8)
        m.part(f"bolt_{i}", "fastener.bolt", d=8, length=40)
        m.part(f"nut_{i}", "fastener.nut", d=8)
        m.seat(f"plate:corner_hole_{i}", f"washer_{i}:seat")
        m.seat(f"washer_{i}:hole", f"bolt_{i}:head_seat")
        m.seat(f"floor:corner_hole_back_{i}", f"nut_{i}:face")
        m.mate(
            "thread_engage", f"bolt_{i}:thread", f"nut_{i}:thread_internal", "T-01 T-02",
            d_t_mm=6.8, through_mm=40 - 1.6 - 24 - 6.8,
        )
    for side, v in (("front", -57), ("back", 57)):
        m.part(side, "bench.cheek")
        m.face("plate:top_face", f"{side}:bottom_face", v_mm=v)
        for i in range(1, 4):
            m.part(f"{side}_bearing_{i}", "bearing.ball")
            m.press(f"{side}:bore_{i}", f"{side}_bearing_{i}:outer_ring", -7)

    # Gears by shaft: name, teeth, middle along the shaft. Turns put a tooth in a gap.
    shafts = [
        (0, [("a1", 20, 40)]),
        (4.5, [("a2", 40, 40), ("b1", 20, 88)]),
        (2.25, [("b2", 40, 88)]),
    ]
    for i, (turn, on) in enumerate(shafts, 1):
        m.part(f"shaft_{i}", "bench.keyed_shaft", keys=[{"at": at} for _, _, at in on])
        m.axis(f"front_bearing_{i}:inner_ring", f"shaft_{i}:seat_start", -7, alpha_deg=turn)
        m.axis(f"back_bearing_{i}:inner_ring", f"shaft_{i}:seat_end", -7)
        for k, (name, teeth, at) in enumerate(on, 1):
            m.part(f"key_{name}", "bench.key")
            m.face(f"shaft_{i}:key_{k}", f"key_{name}:bottom")
            m.part(f"gear_{name}", "bench.keyed_gear", teeth=teeth)
            m.axis(f"shaft_{i}:middle", f"gear_{name}:bore", at + 10 - 64)
            for side, top in (("before", at - 10), ("after", at + 20)):
                m.part(f"{side}_{name}", "base_frame.boss", diameter=35, height=10, bore_d=25.05)
                m.axis(f"shaft_{i}:middle", f"{side}_{name}:bore_port", top - 64)
    m.mesh("gear_a1", "gear_a2")
    m.mesh("gear_b1", "gear_b2")
    return m.draft


def bearings():
    """a shaft in a block by two bearings, whose rings with grooves, cages and balls are parts; the outer rings have one
    shoulder, without which no straight way would lead to their places"""
    m = Machine("bearings", "block")
    m.part("block", "base_frame.housing_block")
    m.part("shaft", SHAFT, segments=[{"d": 20, "length": 60}])
    m.axis("block:bore_port", "shaft:shaft_seat_1", -20)
    for name, d, turned in (("front", -7, "same"), ("back", -33, "opposed")):
        m.part(f"{name}_outer", "bench.outer_ring")
        m.press("block:bore_port", f"{name}_outer:outer", d, direction=turned)
        m.part(f"{name}_inner", "bench.inner_ring")
        # The ring's mouth is at its end, the seat's origin in the middle of the shaft.
        m.press("shaft:shaft_seat_1", f"{name}_inner:bore", d + 20 + 7)
        m.part(f"{name}_cage", "bench.cage")
        m.axis(f"{name}_inner:bore", f"{name}_cage:bore", -1)
        for i in range(1, 7):
            m.part(f"{name}_ball_{i}", "bench.ball")
            m.axis(f"{name}_cage:pocket_{i}", f"{name}_ball_{i}:hole", 16.75 + 3.96 - 18.1)
    return m.draft


def planets():
    """a sun, four planets on pins of a carrier, and an internal ring of 72 teeth"""
    m = Machine("planets", "base")
    m.part("base", PLATE, length=180, width=180, thickness=10)
    m.part("ring", "bench.ring")
    m.face("base:top_face", "ring:bottom_face")
    m.part(
        "carrier", "base_frame.bolt_circle_flange",
        diameter=130, height=32, bore_d=20.1, bolt_d=8, bolt_count=4, bolt_circle_d=96, hole_d=10,
    )
    # Upside down over the ring: its back is up.
    m.face("ring:top_face", "carrier:top_face", d_n_mm=2)
    m.part("shaft", SHAFT, segments=[{"d": 20, "length": 69}])
    m.axis("carrier:bore_port_back", "shaft:shaft_seat_1", -12.5)
    m.part("sun", SPUR, teeth=24, width=10, bore_d=20, backlash_mm=0.1)
    m.press("shaft:shaft_seat_1", "sun:bore", -23.5)
    m.part("hub", "base_frame.coupling_hub", length=20)
    m.press("shaft:shaft_seat_1", "hub:shaft_seat", 34.5)
    for i in range(1, 5):
        m.part(f"pin_{i}", SHAFT, segments=[{"d": 10, "length": 47.5}])
        m.press(f"carrier:bolt_hole_back_{i}", f"pin_{i}:shaft_seat_1", -23.75)
        m.part(f"washer_{i}", "fastener.washer", d=10)
        m.axis(f"pin_{i}:shaft_seat_1", f"washer_{i}:hole", -22.25)
        m.part(f"planet_{i}", SPUR, teeth=24, width=10, bore_d=10.02, backlash_mm=0.1)
        m.axis(f"pin_{i}:shaft_seat_1", f"planet_{i}:bore", -12.25, alpha_deg=7.5)
        m.mesh("sun", f"planet_{i}")
        m.mesh("ring", f"planet_{i}")
    return m.draft


MACHINES = {made.__name__: made for made in (gears, gearbox, bearings, planets)}
