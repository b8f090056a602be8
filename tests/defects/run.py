#!/usr/bin/env python3
"""Puts every assembly of this folder, as it is and broken, before one server per job, and prints what it says.

    python3 tests/defects/run.py --bin target/release/assemcad [--only substr] [--jobs 2] [--json out.json]

README.md tells how the cases are written.
"""

import argparse
import collections
import copy
import json
import pathlib
import queue
import re
import subprocess
import sys
import tempfile
import threading
import time

import yaml

HERE = pathlib.Path(__file__).parent
LIMIT = 300


# Cases

def walk(tree, path):
    """The holder and the key of a path: lists of things with ids go by id, other lists by number."""
    steps = path.split("/")
    for step in steps[:-1]:
        tree = step_of(tree, step)
    return tree, steps[-1]


def index(items, step):
    for i, item in enumerate(items):
        if isinstance(item, dict) and item.get("id", item.get("part")) == step:
            return i
    return int(step)


def step_of(tree, step):
    if isinstance(tree, list):
        return tree[index(tree, step)]
    return tree.setdefault(step, {})


def edit(assembly, change):
    """One edit of an assembly, in place."""
    if "set" in change:
        holder, key = walk(assembly, change["set"])
        if isinstance(holder, list):
            key = index(holder, key)
        holder[key] = copy.deepcopy(change["to"])
    elif "remove" in change:
        holder, key = walk(assembly, change["remove"])
        if isinstance(holder, list):
            gone = holder.pop(index(holder, key))
            if holder is assembly.get("parts"):
                forget(assembly, gone["id"])
        else:
            del holder[key]
    elif "add" in change:
        assembly.setdefault(change["add"], []).append(copy.deepcopy(change["value"]))
    else:
        raise ValueError(f"no such edit: {change}")


def forget(assembly, part):
    """What is said of a part that is gone."""
    for key in ("intended_motions", "free"):
        if key in assembly:
            assembly[key] = [m for m in assembly[key] if m["part"] != part]
    for rule in assembly.get("accept", []):
        rule["parts"] = [p for p in rule["parts"] if p != part]
    assembly["mates"] = [m for m in assembly["mates"] if part not in (m["base"]["ref"], m["incoming"]["ref"])]


def load(folder, only):
    """All cases of a folder of folders."""
    cases = []
    for path in sorted(folder.glob("*/assembly.yaml")):
        name = path.parent.name
        base = yaml.safe_load(path.read_text())["assembly"]
        file = path.parent / "defects.yaml"
        whole = yaml.safe_load(file.read_text()) if file.exists() else {}
        entries = [{"id": "as_it_is", "expect": "pass", "edits": [], "why": whole.get("why", ""), **whole.get("base", {})}]
        for entry in entries + (whole.get("cases") or []):
            case = {**entry, "id": f"{name}/{entry['id']}"}
            if only and not any(o in case["id"] or o == case.get("mechanism") for o in only):
                continue
            assembly = copy.deepcopy(base)
            try:
                for change in entry["edits"]:
                    edit(assembly, change)
            except (ValueError, KeyError, IndexError) as e:
                raise SystemExit(f"{case['id']}: the edits cannot be made: {e!r}")
            assembly["id"] = re.sub(r"[^a-z0-9_]", "_", case["id"])
            case["assembly"] = assembly
            cases.append(case)
    return cases


# The server

class Server:
    def __init__(self, binary, root):
        self.child = subprocess.Popen(
            [binary, "serve", "--root", root], stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True
        )
        self.next = 0
        self.answers = queue.Queue()
        threading.Thread(target=self.read, daemon=True).start()
        hello = {"name": "faults", "version": "1"}
        self.request("initialize", {"protocolVersion": "2025-06-18", "capabilities": {}, "clientInfo": hello})
        self.send({"jsonrpc": "2.0", "method": "notifications/initialized"})

    def read(self):
        for line in self.child.stdout:
            self.answers.put(json.loads(line))
        self.answers.put(None)

    def send(self, message):
        self.child.stdin.write(json.dumps(message) + "\n")
        self.child.stdin.flush()

    def request(self, method, params):
        self.next += 1
        self.send({"jsonrpc": "2.0", "id": self.next, "method": method, "params": params})
        while True:
            answer = self.answers.get(timeout=LIMIT)
            if answer is None:
                raise RuntimeError("the server has ended")
            if answer.get("id") == self.next:
                return answer.get("result") or answer

    def call(self, tool, **arguments):
        result = self.request("tools/call", {"name": tool, "arguments": arguments})
        return result.get("structuredContent") or {"text": json.dumps(result)}

    def end(self):
        self.child.stdin.close()
        try:
            self.child.wait(10)
        except subprocess.TimeoutExpired:
            self.child.kill()


def admit(server, names):
    """Admits the factories of the cases; their names with versions."""
    known = {}
    for name in sorted(names):
        request = yaml.safe_load((HERE / "factories" / f"{name}.yaml").read_text())
        source = (HERE / "factories" / f"{name}.star").read_text()
        answer = server.call("synthesize_factory", name=name, source=source, sets="defaults", **request)
        if answer.get("status") not in ("admitted", "known"):
            raise SystemExit(f"{name} is not admitted: {json.dumps(answer)[:3000]}")
        known[name] = answer.get("factory") or answer.get("name") or name
    return known


# What the server says

def judge(case, answer):
    """The outcome of a case, and the codes of what was told."""
    findings = answer.get("findings") or []
    wrong = [f for f in findings if f["verdict"] != "pass"]
    diagnostics = answer.get("diagnostics") or []
    errors = [d for d in diagnostics if d.get("severity") == "error"]
    codes = collections.Counter()
    for f in wrong:
        broken = [a["axiom"] for a in f.get("axioms") or [] if a["role"] in ("broken", "open")]
        codes["/".join([f["check"], f["diagnostic"]["code"], *broken])] += 1
    if not wrong:
        for d in errors:
            codes["refused/" + d["code"]] += 1
    verdict = answer.get("verdict") or ("fail" if errors or "text" in answer else "none")
    if case["expect"] == "pass":
        return {"pass": "right", "indeterminate": "open"}.get(verdict, "false alarm"), codes
    if verdict == "pass":
        return "missed", codes
    at = set(case["at"])

    def here(f):
        return at & (set(f.get("parts") or []) | set(f.get("mates") or []))

    if any(f["verdict"] == "fail" and here(f) for f in wrong):
        return "found", codes
    if not wrong and at & blamed(case["assembly"], errors):
        return "found", codes
    if verdict == "indeterminate" or any(here(f) for f in wrong):
        return "open", codes
    return "elsewhere", codes


def blamed(assembly, errors):
    """The parts and mates that a refused draft is refused for; none where the words are wrong, not the design."""
    out = set()
    for d in errors:
        where = re.search(r"(parts|mates)\[(\d+)\](.*)", d.get("where", ""))
        if not where or where[3].endswith("mate_type") or d["code"] in ("name_invalid", "specification_invalid"):
            continue
        thing = assembly[where[1]][int(where[2])]
        out.add(thing["id"])
        if where[1] == "mates":
            out |= {thing["base"]["ref"], thing["incoming"]["ref"]}
    return out


def told(answer, most=6):
    out = []
    for f in answer.get("findings") or []:
        if f["verdict"] != "pass":
            broken = [a["axiom"] for a in f.get("axioms") or [] if a["role"] == "broken"]
            out.append(f"{f['verdict']} {f['check']} {','.join(broken)} {f.get('parts')}: {f['diagnostic']['message']}")
    if not out:
        out = [f"{d['code']} {d['where']}: {d['message']}" for d in answer.get("diagnostics") or []]
    if not out and answer.get("verdict") != "pass":
        out = [json.dumps(answer)[:600]]
    return out[:most] + ([f"and {len(out) - most} more"] if len(out) > most else [])


def work(binary, todo, results, lock, show):
    root = tempfile.mkdtemp(prefix="faults-")
    server = Server(binary, root)
    known = None
    while True:
        try:
            case = todo.get_nowait()
        except queue.Empty:
            break
        for attempt in (1, 2):
            try:
                if known is None:
                    known = admit(server, work.names)
                assembly = copy.deepcopy(case["assembly"])
                for part in assembly["parts"]:
                    part["factory"] = known.get(part["factory"], part["factory"])
                begun = time.time()
                arguments = {"draft": json.dumps({"assembly": assembly}), "keep_failed": True}
                if "tau_mm3" in case:
                    arguments["tau_mm3"] = case["tau_mm3"]
                answer = server.call("realize", **arguments)
                stages = answer.get("stages") or []
                answer["diagnostics"] = [d for stage in stages for d in stage.get("diagnostics") or []]
                if answer.get("realized") and answer.get("verdict") != "pass":
                    again = {k: v for k, v in arguments.items() if k == "tau_mm3"}
                    answer = server.call("verify", assembly=assembly["id"], detail="full", **again)
                took = time.time() - begun
                break
            except (RuntimeError, queue.Empty, BrokenPipeError) as e:
                server.end()
                server = Server(binary, root)
                known = None
                answer, took = {"verdict": "indeterminate", "text": repr(e)}, LIMIT
        outcome, codes = judge(case, answer)
        row = {k: v for k, v in case.items() if k not in ("assembly", "edits")}
        row.update(outcome=outcome, verdict=answer.get("verdict"), codes=dict(codes), told=told(answer), seconds=round(took, 1))
        with lock:
            results.append(row)
            print(f"{outcome:12} {took:6.1f} s  {case['id']}  {' '.join(codes)}"[:220], file=sys.stderr, flush=True)
            if show or outcome not in ("found", "right"):
                for line in row["told"] if show or case["expect"] == "pass" else row["told"][:2]:
                    print(f"             {line}"[:300], file=sys.stderr, flush=True)
    server.end()


def table(results):
    lines = []
    wrong = [r for r in results if r["expect"] == "fail"]
    good = [r for r in results if r["expect"] == "pass"]
    kinds = ["found", "missed", "elsewhere", "open"]
    for key in ("mechanism", "form", "dodge"):
        rows = collections.defaultdict(collections.Counter)
        for r in wrong:
            if r.get(key):
                rows[r[key]][r["outcome"]] += 1
        lines.append(f"{key:20}" + "".join(f"{k:>12}" for k in ["cases", *kinds]))
        for name in sorted(rows):
            lines.append(f"{name:20}" + "".join(f"{n:12}" for n in [sum(rows[name].values()), *(rows[name][k] for k in kinds)]))
        if key == "mechanism":
            total = collections.Counter(r["outcome"] for r in wrong)
            lines.append(f"{'all':20}" + "".join(f"{n:12}" for n in [len(wrong), *(total[k] for k in kinds)]))
        lines.append("")
    total = collections.Counter(r["outcome"] for r in good)
    lines.append(f"sound: {len(good)}, right {total['right']}, false alarm {total['false alarm']}, open {total['open']}")
    for outcome in ("missed", "elsewhere", "open", "false alarm"):
        rows = sorted((r for r in results if r["outcome"] == outcome), key=lambda r: (r.get("mechanism") or "", r["id"]))
        if rows:
            lines += ["", f"{outcome}:"]
        for r in rows:
            what = f"{r.get('mechanism', 'sound')} {r.get('form', '')} {r.get('dodge', '')}".strip()
            lines.append(f"  {r['id']}  [{what}] {r['why']}")
            lines += [f"      {line}"[:240] for line in r["told"][:3]]
    return "\n".join(lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--bin", required=True, help="the server")
    parser.add_argument("--only", action="append", help="cases whose id holds this, or of this mechanism")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--json", help="where all results go")
    parser.add_argument("--show", action="store_true", help="what was told of every case")
    args = parser.parse_args()
    cases = load(HERE, args.only)
    ids = collections.Counter(c["id"] for c in cases)
    twice = [i for i, n in ids.items() if n > 1]
    if twice:
        raise SystemExit(f"twice: {twice}")
    work.names = {p["factory"] for c in cases for p in c["assembly"]["parts"] if p["factory"].startswith("user.")}
    todo, results, lock = queue.Queue(), [], threading.Lock()
    for case in cases:
        todo.put(case)
    jobs = [threading.Thread(target=work, args=(args.bin, todo, results, lock, args.show)) for _ in range(args.jobs)]
    for job in jobs:
        job.start()
    for job in jobs:
        job.join()
    order = {c["id"]: i for i, c in enumerate(cases)}
    results.sort(key=lambda r: order[r["id"]])
    if args.json:
        pathlib.Path(args.json).write_text(json.dumps(results, indent=1))
    print(table(results))
    if len(results) < len(cases):
        raise SystemExit(f"{len(cases) - len(results)} cases were not run")
    bad = [r for r in results if r["outcome"] not in ("found", "right")]
    raise SystemExit(1 if bad else 0)


if __name__ == "__main__":
    main()
