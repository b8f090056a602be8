"""Times the server against CadQuery on the same assemblies and writes docs/speed.md.

    run.py [--sizes 18,50] [--machines gears] [--binary FILE] [--limit S] [--peer-limit S] [--out FILE]

Each assembly has a server with an empty folder of its own, so that nothing is known beforehand; CadQuery
runs right after it, so that both meet the same load of the machine.
"""

import argparse
import json
import math
import os
import platform
import subprocess
import sys
import tempfile
from importlib.metadata import version
from pathlib import Path

import joint
import machines
from session import Process, Session, TooSlow

HERE = Path(__file__).resolve().parent
TOP = HERE.parent.parent

# The whole job as a part of CadQuery's, by number of parts.
WHOLE = {18: 1 / 4, 50: 1 / 2, 194: 1 / 3, 1002: 1 / 10}

GROWTH = 1.2
FIRST_ANSWER_S = 0.1
AGAIN_S = 0.1
CHANGED = 1 / 10

# The size at which `verify` is held to its targets.
HELD = 194


class Over(float):
    """A time that was not waited for: more than this."""


def stage(answer, name):
    took = next(s for s in answer["stages"] if s["stage"] == name).get("elapsed_ms")
    return None if took is None else took / 1000


def realized(session, draft, row):
    """What both tables know of an assembly's first run; its STEP file, if there is one."""
    answer, row["realize_s"], row["realize_calls"] = session.call(
        "realize", draft=json.dumps(draft), keep_failed=True
    )
    row["whole_s"] = session.answered - session.began
    row["verdict"] = answer.get("verdict", "?")
    row["verify_s"] = stage(answer, "verify")
    row["export_s"] = stage(answer, "export")
    if row["verdict"] != "pass":
        findings = [f for s in answer["stages"] for f in s.get("findings", [])]
        row["findings"] = findings
        print(json.dumps(findings)[:3000], file=sys.stderr)
    return answer.get("step_file")


def server(binary, draft, limit, row, more=None):
    """Runs the server on a draft; `more` goes on in the session, with the STEP file."""
    with tempfile.TemporaryDirectory() as folder:
        session = Session(binary, folder, HERE / "factories", limit)
        try:
            session.open()
            session.call("list_factories")
            row["first_answer_s"] = session.answered - session.began
            step = realized(session, draft, row)
            if more and step:
                more(session, Path(folder) / step)
        except TooSlow as step:
            row["too_slow"] = str(step)
            row.setdefault("whole_s", Over(limit))
        except (RuntimeError, OSError) as error:
            row["error"] = str(error)
            print(f"  {error}", file=sys.stderr)
        finally:
            session.end()
            row["memory"] = session.peak


def peer(limit, row, *command):
    process = Process([sys.executable, HERE / "peer.py", *map(str, command)], stdout=subprocess.PIPE, text=True)
    try:
        out, _ = process.child.communicate(timeout=limit)
        row["peer_whole_s"] = process.elapsed()
        row.update({f"peer_{key}": value for key, value in json.loads(out).items()})
    except subprocess.TimeoutExpired:
        row["peer_whole_s"] = row["peer_interference_s"] = Over(limit)
    except ValueError:
        row["peer_error"] = f"exit code {process.child.returncode}"
    finally:
        process.end()
        row["peer_memory"] = process.peak


def size(parts, options):
    row = {"parts": parts}

    def more(session, _):
        name = f"joint_{parts}"
        _, row["again_s"], row["again_calls"] = session.call("verify", assembly=name)
        joint.lengthen(session, parts)
        changed, row["changed_s"], row["changed_calls"] = session.call("verify", assembly=name)
        if row["verdict"] == "pass" and changed["verdict"] != "pass":
            row["verdict"] = f"{changed['verdict']} after the change"

    server(options.binary, joint.draft(parts), options.limit, row, more)
    with tempfile.TemporaryDirectory() as folder:
        peer(options.peer_limit, row, "joint", parts, Path(folder) / "joint.step")
    return row


def machine(name, options):
    draft = machines.MACHINES[name]()
    row = {"machine": name, "parts": len(draft["assembly"]["parts"])}
    server(
        options.binary, draft, options.limit, row,
        lambda _, step: peer(options.peer_limit, row, "interference", step),
    )
    return row


def quotient(a, b):
    return a / b if a is not None and b else None


def growth(rows, key):
    """The slope of time over parts, both logarithmic."""
    points = [(math.log(r["parts"]), math.log(r[key])) for r in rows if r.get(key) and type(r[key]) is not Over]
    if len(points) < 2:
        return None
    x, y = (sum(p[k] for p in points) / len(points) for k in (0, 1))
    return sum((a - x) * (b - y) for a, b in points) / sum((a - x) ** 2 for a, _ in points)


def s(value):
    if value is None:
        return "-"
    return ("> " if type(value) is Over else "") + (f"{value:.0f}" if value >= 100 else f"{value:.2f}")


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
    yield f"whole job grows with parts to the power of at most {GROWTH}", s(slope), met(slope, GROWTH)
    slowest = max((r["first_answer_s"] for r in sizes + engines if "first_answer_s" in r), default=None)
    yield f"start to first answer at most {FIRST_ANSWER_S} s", s(slowest), met(slowest, FIRST_ANSWER_S)
    for r in (r for r in sizes if r["parts"] == HELD):
        again, calls = r.get("again_s"), r.get("again_calls")
        yield f"{HELD} parts: `verify` again at most {AGAIN_S} s", s(again), met(again, AGAIN_S)
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
                    [n(r["parts"]), verdict(r), s(r.get("first_answer_s")), s(r.get("realize_s")), s(r.get("verify_s")),
                     s(r.get("whole_s")), s(r.get("peer_whole_s")), times(r.get("whole_s"), r.get("peer_whole_s")),
                     mb(r.get("memory")), mb(r.get("peer_memory"))]
                    for r in sizes
                ],
            ),
            "First: within `realize`. Again: nothing changed. Changed: one bolt taken out and a longer one put in.\n",
            table(
                ["parts", "first verify", "kernel calls of `realize`", "CadQuery's interference", "again",
                 "kernel calls", "changed", "kernel calls", "changed / first"],
                [
                    [n(r["parts"]), s(r.get("verify_s")), n(r.get("realize_calls")), s(r.get("peer_interference_s")),
                     s(r.get("again_s")), n(r.get("again_calls")), s(r.get("changed_s")), n(r.get("changed_calls")),
                     times(r.get("changed_s"), r.get("verify_s"))]
                    for r in sizes
                ],
            ),
            f"Growth: the whole job with parts to the power of {s(growth(sizes, 'whole_s'))}, CadQuery's"
            f" {s(growth(sizes, 'peer_whole_s'))} (least squares of the logarithms).\n",
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
                    [r["machine"], n(r["parts"]), verdict(r), s(r.get("whole_s")), s(r.get("verify_s")),
                     n(r.get("realize_calls")), s(r.get("peer_interference_s")),
                     times(r.get("verify_s"), r.get("peer_interference_s")), mb(r.get("memory")),
                     mb(r.get("peer_memory"))]
                    for r in engines
                ],
            ),
            "".join(f"- {name}: {made.__doc__}\n" for name, made in machines.MACHINES.items()),
        ]
    text += ["## Targets\n", table(["target", "measured", "met"], [list(t) for t in targets(sizes, engines)])]
    return "\n".join(text)


def plain(value):
    """Bounds as text."""
    if isinstance(value, dict):
        return {key: plain(v) for key, v in value.items()}
    return s(value) if type(value) is Over else value


def names(text):
    return [name for name in text.split(",") if name]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--sizes", default="18,50,194,1002", help="numbers of parts of the joint")
    parser.add_argument("--machines", default=",".join(machines.MACHINES), help="names, or '' for none")
    parser.add_argument("--binary", default=TOP / "target/release/assemcad", help="the server")
    parser.add_argument("--limit", type=float, default=300, help="longest wait for one answer of the server, in s")
    parser.add_argument("--peer-limit", type=float, default=1800, help="longest wait for CadQuery, in s")
    parser.add_argument("--out", type=Path, default=TOP / "docs/speed.md", help="the page; its numbers beside it")
    options = parser.parse_args()

    sizes, engines = [], []
    for rows, run, given in ((sizes, size, names(options.sizes)), (engines, machine, names(options.machines))):
        for what in given:
            print(f"{what} ...", flush=True)
            rows.append(run(int(what) if run is size else what, options))
            r = rows[-1]
            print(
                f"  {verdict(r)}: whole {s(r.get('whole_s'))}, verify {s(r.get('verify_s'))}, CadQuery"
                f" {s(r.get('peer_whole_s'))}, its interference {s(r.get('peer_interference_s'))}",
                flush=True,
            )
            # After each, for a run that is broken off.
            options.out.write_text(page(sizes, engines))
            numbers = {"sizes": [plain(r) for r in sizes], "machines": [plain(r) for r in engines]}
            options.out.with_suffix(".json").write_text(json.dumps(numbers, indent=1) + "\n")


main()
