"""Times the server against CadQuery on the same assemblies and writes docs/speed.md.

    run.py [--sizes 18,50] [--machines gears] [--binary FILE] [--limit S] [--peer-limit S] [--out FILE]

Each assembly has a server with an empty folder of its own, so that nothing is known beforehand; CadQuery
runs right after it, so that both meet the same load of the machine.
"""

import argparse
import json
import subprocess
import sys
import tempfile
from pathlib import Path

import joint
import machines
from page import page, seconds, verdict
from session import Over, Process, Session, TooSlow

HERE = Path(__file__).resolve().parent
TOP = HERE.parent.parent


def stage(answer, name):
    took = next(s for s in answer["stages"] if s["stage"] == name).get("elapsed_ms")
    return None if took is None else took / 1000


def realized(session, draft, row):
    """What both tables know of an assembly's first run; its STEP file, if there is one."""
    answer, row["realize_s"] = session.call("realize", draft=json.dumps(draft), keep_failed=True)
    row["whole_s"] = session.answered - session.began
    row["realize_calls"] = session.kernel_calls()
    row["verdict"] = answer.get("verdict", "?")
    row["verify_s"] = stage(answer, "verify")
    row["export_s"] = stage(answer, "export")
    if row["verdict"] != "pass":
        findings = [f for s in answer["stages"] for f in s.get("findings", [])]
        row["findings"] = findings
        for finding in [f for f in findings if f.get("verdict") != "pass"][:5]:
            print("  " + finding["diagnostic"]["message"][:300], file=sys.stderr)
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
        row["again_s"] = Over(options.limit)
        _, row["again_s"] = session.call("verify", assembly=name)
        row["again_calls"] = session.kernel_calls()
        joint.lengthen(session, parts)
        session.kernel_calls()
        row["changed_s"] = Over(options.limit)
        changed, row["changed_s"] = session.call("verify", assembly=name)
        row["changed_calls"] = session.kernel_calls()
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


def plain(value):
    """Bounds as text."""
    if isinstance(value, dict):
        return {key: plain(v) for key, v in value.items()}
    return seconds(value) if type(value) is Over else value


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
                f"  {verdict(r)}: whole {seconds(r.get('whole_s'))}, verify {seconds(r.get('verify_s'))}, CadQuery"
                f" {seconds(r.get('peer_whole_s'))}, its interference {seconds(r.get('peer_interference_s'))}",
                flush=True,
            )
            # After each, for a run that is broken off.
            options.out.write_text(page(sizes, engines))
            numbers = {"sizes": [plain(r) for r in sizes], "machines": [plain(r) for r in engines]}
            options.out.with_suffix(".json").write_text(json.dumps(numbers, indent=1) + "\n")


main()
