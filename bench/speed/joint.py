"""The bolted flange joint: two flanges, and a bolt, two washers and a nut for each hole."""

import math

# ISO 4014, 4032 and 7089, M8, in mm: what the built-in factories make.
D, HEAD_S, HEAD_K, BOLT_L = 8, 13, 5.3, 40
NUT_M, NUT_HOLE = 6.8, 8 - 1.0825317547305483 * 1.25
WASHER_I, WASHER_O, WASHER_H = 8.4, 16, 1.6
HOLE, HEIGHT, RIM = 9, 12, 25

# How far a bolt stands out of its nut.
THROUGH = BOLT_L - 2 * WASHER_H - 2 * HEIGHT - NUT_M


def holes(parts):
    n, rest = divmod(parts - 2, 4)
    if rest or n < 4:
        raise SystemExit(f"{parts} parts: a joint has 2 + 4 n of them, n at least 4")
    return n


def circle_d(n):
    return max(100, math.ceil(26 / math.sin(math.pi / n)))


def mate(name, kind, base, incoming, axioms, **options):
    def port(text):
        ref, port = text.split(":")
        return {"ref": ref, "port": port}

    made = {"id": name, "mate_type": kind, "base": port(base), "incoming": port(incoming), "axioms": axioms}
    return {**made, "options": options} if options else made


def bolt_mates(i, length=BOLT_L):
    """What places a bolt and screws it in its nut."""
    through = THROUGH + length - BOLT_L
    return [
        mate(f"b_{i}", "coaxial_face", f"over_{i}:hole", f"bolt_{i}:head_seat", ["T-10", "T-06"]),
        mate(
            f"t_{i}", "thread_engage", f"bolt_{i}:thread", f"nut_{i}:thread_internal", ["T-01", "T-02"],
            d_t_mm=NUT_M, through_mm=through,
        ),
    ]


def draft(parts):
    n = holes(parts)
    flange = {"n": n, "circle_d": circle_d(n), "height": HEIGHT}
    all_parts = [{"id": f, "factory": "bench.flange", "params": flange} for f in ("lower", "upper")]
    mates = [mate("stack", "face_to_face", "lower:top_face", "upper:bottom_face", ["C-01"])]
    for i in range(1, n + 1):
        all_parts += [
            {"id": f"over_{i}", "factory": "fastener.washer", "params": {"d": D}},
            {"id": f"under_{i}", "factory": "fastener.washer", "params": {"d": D}},
            {"id": f"bolt_{i}", "factory": "fastener.bolt", "params": {"d": D, "length": BOLT_L}},
            {"id": f"nut_{i}", "factory": "fastener.nut", "params": {"d": D}},
        ]
        placed, screwed = bolt_mates(i)
        mates += [
            mate(f"o_{i}", "coaxial_face", f"upper:hole_{i}", f"over_{i}:seat", ["T-10"]),
            placed,
            mate(f"u_{i}", "coaxial_face", f"lower:hole_back_{i}", f"under_{i}:seat", ["T-10"]),
            mate(f"n_{i}", "coaxial_face", f"under_{i}:hole", f"nut_{i}:face", ["T-10"]),
            screwed,
        ]
    return {"assembly": {"id": f"joint_{parts}", "root": "lower", "parts": all_parts, "mates": mates}}


def lengthen(session, parts, length=45):
    """Changes one bolt's length by the tools for it."""
    name, i = f"joint_{parts}", 1
    for kind, what in (("mate", f"t_{i}"), ("mate", f"b_{i}"), ("part", f"bolt_{i}")):
        session.call("remove", assembly=name, kind=kind, name=what)
    params = {"d": D, "length": length}
    session.call("add_part", assembly=name, part=f"bolt_{i}", factory="fastener.bolt", params=params)
    for made in bolt_mates(i, length):
        ends = {end: "{ref}:{port}".format(**made[end]) for end in ("base", "incoming")}
        rest = {key: made[key] for key in ("id", "mate_type", "axioms")}
        session.call("mate", assembly=name, **rest, **ends, **made.get("options", {}))
