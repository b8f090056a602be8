"""The page with the tables, and the targets that they are held to."""

import math
import os
import platform
from importlib.metadata import version

import machines
from session import Over

# The whole job as a part of CadQuery's, by number of parts.
WHOLE = {18: 1 / 4, 50: 1 / 2, 194: 1 / 3, 1002: 1 / 10}

GROWTH = 1.2
FIRST_ANSWER_S = 0.1
AGAIN_S = 0.1
CHANGED = 1 / 10

# The size at which `verify` is held to its targets.
HELD = 194


def quotient(a, b):
    return a / b if a is not None and b else None


def growth(rows, key):
    """The slope of time over parts, both logarithmic."""
    points = [(math.log(r["parts"]), math.log(r[key])) for r in rows if r.get(key) and type(r[key]) is not Over]
    if len(points) < 2:
        return None
    x, y = (sum(p[k] for p in points) / len(points) for k in (0, 1))
    return sum((a - x) * (b - y) for a, b in points) / sum((a - x) ** 2 for a, _ in points)


def seconds(value):
    if value is None:
        return "-"
    return ("> " if type(value) is Over else "") + (f"{value:.0f}" if value >= 100 else f"{value:.2f}")


def t(row, key):
    return seconds(row.get(key))


def n(value):
    return "-" if value is None else str(value)


def mb(value):
    return f"{value / 1e6:.0f}" if value else "-"


def times(ours, peers):
    """Ours as a part of theirs."""
    q = quotient(ours, peers)
    if q is None or (type(ours) is Over and type(peers) is Over):
        return "-"
    bound = ">= " if type(ours) is Over else "<= " if type(peers) is Over else ""
    return f"{bound}{q:.2f}" if q < 10 else f"{bound}{q:.0f}"


def met(ours, most):
    """A limit that is itself only a lower bound can be kept, but not be broken."""
    if ours is None or most is None:
        return "-"
    if ours <= most:
        return "-" if type(ours) is Over else "yes"
    return "-" if type(most) is Over else "NO"


def part_of(share, whole):
    """A share of a time, a bound where that one is."""
    return None if whole is None else type(whole)(share * whole)


def table(head, rows):
    lines = [head, ["---"] * len(head), *rows]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines) + "\n"


def verdict(row):
    found = row.get("verdict") or (f"too slow: {row['too_slow']}" if "too_slow" in row else "error")
    return found if found == "pass" else f"**{found}**"


def targets(sizes, engines):
    """Target, measured, whether it is met."""
    for r in sizes:
        share = WHOLE.get(r["parts"])
        ours, peers = r.get("whole_s"), r.get("peer_whole_s")
        if share:
            yield (
                f"{r['parts']} parts: whole job at most 1/{1 / share:.0f} of CadQuery's",
                times(ours, peers),
                met(ours, part_of(share, peers)),
            )
    slope = growth(sizes, "whole_s")
    yield f"whole job grows with parts to the power of at most {GROWTH}", seconds(slope), met(slope, GROWTH)
    slowest = max((r["first_answer_s"] for r in sizes + engines if "first_answer_s" in r), default=None)
    yield f"start to first answer at most {FIRST_ANSWER_S} s", seconds(slowest), met(slowest, FIRST_ANSWER_S)
    for r in (r for r in sizes if r["parts"] == HELD):
        again, calls = r.get("again_s"), r.get("again_calls")
        yield f"{HELD} parts: `verify` again at most {AGAIN_S} s", seconds(again), met(again, AGAIN_S)
        yield f"{HELD} parts: `verify` again without kernel calls", n(calls), met(calls, 0)
        first, changed = r.get("verify_s"), r.get("changed_s")
        yield (
            f"{HELD} parts: `verify` after a change at most 1/{1 / CHANGED:.0f} of the first",
            times(changed, first),
            met(changed, part_of(CHANGED, first)),
        )
    for r in engines:
        ours, peers = r.get("verify_s"), r.get("peer_interference_s")
        yield f"{r['machine']}: first `verify` at most CadQuery's interference", times(ours, peers), met(ours, peers)
    for r in sizes:
        ours, peers = r.get("memory") or None, r.get("peer_memory") or None
        yield f"{r['parts']} parts: peak memory below CadQuery's", times(ours, peers), met(ours, peers)
    broken = [str(r.get("machine", r["parts"])) for r in sizes + engines if r.get("verdict") != "pass"]
    yield "every verdict is pass", ", ".join(broken) or "pass", "NO" if broken else "yes"


def page(sizes, engines):
    text = [
        "# Speed beside CadQuery\n",
        "Written by `make speed`; do not edit.\n",
        f"{os.cpu_count()} processor cores, {platform.system()} {platform.machine()}, CadQuery"
        f" {version('cadquery')}. Times in s, memory in MB: the proportional set size of all processes, the most"
        " of samples 50 ms apart. Each assembly has a server of its own that starts with an empty folder; what was"
        " not waited for is `> limit`, what was not measured `-`.\n",
    ]
    if sizes:
        text += [
            "## A bolted flange joint\n",
            "Two flanges, and a bolt, two washers and a nut for each hole; every nut is screwed on its bolt. Whole job:"
            " from the start of the process to the STEP file, verified; CadQuery builds each distinct solid once,"
            " intersects all pairs whose boxes meet and exports.\n",
            table(
                ["parts", "verdict", "first answer", "`realize`", "of it verify", "whole job", "CadQuery", "share",
                 "memory", "CadQuery"],
                [
                    [n(r["parts"]), verdict(r), t(r, "first_answer_s"), t(r, "realize_s"), t(r, "verify_s"),
                     t(r, "whole_s"), t(r, "peer_whole_s"), times(r.get("whole_s"), r.get("peer_whole_s")),
                     mb(r.get("memory")), mb(r.get("peer_memory"))]
                    for r in sizes
                ],
            ),
            "First: within `realize`. Again: nothing changed. Changed: one bolt taken out and a longer one put in.\n",
            table(
                ["parts", "first verify", "kernel calls of `realize`", "CadQuery's interference", "again",
                 "kernel calls", "changed", "kernel calls", "changed / first"],
                [
                    [n(r["parts"]), t(r, "verify_s"), n(r.get("realize_calls")), t(r, "peer_interference_s"),
                     t(r, "again_s"), n(r.get("again_calls")), t(r, "changed_s"), n(r.get("changed_calls")),
                     times(r.get("changed_s"), r.get("verify_s"))]
                    for r in sizes
                ],
            ),
            f"Growth: the whole job with parts to the power of {seconds(growth(sizes, 'whole_s'))}, CadQuery's"
            f" {seconds(growth(sizes, 'peer_whole_s'))} (least squares of the logarithms).\n",
        ]
    if engines:
        text += [
            "## Machines\n",
            "CadQuery reads the STEP file that the server has exported, so that both have the same solids, and"
            " intersects all pairs whose boxes meet; the reading is not counted. The first `verify` checks solids,"
            " ports, mates, contact, freedom and axioms too.\n",
            table(
                ["machine", "parts", "verdict", "whole job", "first verify", "kernel calls of `realize`",
                 "CadQuery's interference", "share", "memory", "CadQuery"],
                [
                    [r["machine"], n(r["parts"]), verdict(r), t(r, "whole_s"), t(r, "verify_s"),
                     n(r.get("realize_calls")), t(r, "peer_interference_s"),
                     times(r.get("verify_s"), r.get("peer_interference_s")), mb(r.get("memory")),
                     mb(r.get("peer_memory"))]
                    for r in engines
                ],
            ),
            "".join(f"- {name}: {' '.join(made.__doc__.split())}\n" for name, made in machines.MACHINES.items()),
        ]
    text += ["## Targets\n", table(["target", "measured", "met"], [list(line) for line in targets(sizes, engines)])]
    return "\n".join(text)
