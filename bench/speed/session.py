"""A client of the server over its real protocol, and the memory of whole trees of processes."""

import json
import os
import queue
import re
import signal
import subprocess
import threading
import time

# How often memory is sampled, in s.
EVERY = 0.05

# How long after an answer its log line may still come, in s.
LATE = 0.05

GEOMETRY = re.compile(r"geometry\b.*\basked=\d+\s+computed=\d+\s+kernel_calls=(\d+)")
COLOUR = re.compile(r"\x1b\[[0-9;]*m")


class TooSlow(Exception):
    """A step has reached the time limit."""


class Over(float):
    """A time that was not waited for: more than this."""


def tree(pid):
    """A process and all below it."""
    pids = [pid]
    for parent in pids:
        try:
            for task in os.listdir(f"/proc/{parent}/task"):
                with open(f"/proc/{parent}/task/{task}/children") as file:
                    pids += [int(child) for child in file.read().split()]
        except OSError:
            pass  # It has ended meanwhile.
    return pids


def pss(pid):
    """The proportional set size in bytes: what processes share is counted once over all of them."""
    try:
        with open(f"/proc/{pid}/smaps_rollup") as file:
            for line in file:
                if line.startswith("Pss:"):
                    return int(line.split()[1]) * 1024
    except OSError:
        pass
    return 0


class Process:
    """A child in a session of its own, sampled from its start to its end."""

    def __init__(self, command, **options):
        self.began = time.perf_counter()
        self.child = subprocess.Popen(command, start_new_session=True, **options)
        self.peak = 0
        self.over = threading.Event()
        self.sampler = threading.Thread(target=self.sample, daemon=True)
        self.sampler.start()

    def sample(self):
        while not self.over.wait(EVERY):
            self.peak = max(self.peak, sum(map(pss, tree(self.child.pid))))

    def elapsed(self):
        return time.perf_counter() - self.began

    def end(self):
        """Ends what is left of the tree; by process, for workers may have sessions of their own."""
        self.over.set()
        self.sampler.join()
        if self.child.poll() is None:
            for pid in tree(self.child.pid):
                try:
                    os.kill(pid, signal.SIGKILL)
                except ProcessLookupError:
                    pass
        self.child.wait()


class Session(Process):
    """A server over a folder."""

    def __init__(self, binary, root, factories, limit):
        self.limit = limit
        self.next = 0
        self.answers = queue.Queue()
        self.calls_before = 0
        self.log = queue.Queue()
        super().__init__(
            [binary, "serve", "--root", str(root), "--factories", str(factories)],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
            env={**os.environ, "ASSEMCAD_LOG": "info"},
        )
        for stream, lines in ((self.child.stdout, self.answers), (self.child.stderr, self.log)):
            threading.Thread(target=self.read, args=(stream, lines), daemon=True).start()

    def open(self):
        hello = {"name": "speed", "version": "1"}
        self.request("initialize", protocolVersion="2025-11-25", capabilities={}, clientInfo=hello)
        self.send({"jsonrpc": "2.0", "method": "notifications/initialized"})

    @staticmethod
    def read(stream, lines):
        for line in stream:
            lines.put(line)
        lines.put(None)

    def send(self, message):
        self.child.stdin.write(json.dumps(message) + "\n")
        self.child.stdin.flush()

    def request(self, method, **params):
        self.next += 1
        self.send({"jsonrpc": "2.0", "id": self.next, "method": method, "params": params})
        until = time.perf_counter() + self.limit
        while True:
            try:
                line = self.answers.get(timeout=max(0, until - time.perf_counter()))
            except queue.Empty:
                raise TooSlow(method) from None
            if line is None:
                raise RuntimeError(f"the server has ended during {method}")
            answer = json.loads(line)
            if answer.get("id") == self.next:
                if "error" in answer:
                    raise RuntimeError(f"{method}: {answer['error']}")
                return answer["result"]

    def call(self, tool, **arguments):
        """A tool's structured answer, and its time in s."""
        while not self.log.empty():
            self.log.get()
        begun = time.perf_counter()
        try:
            result = self.request("tools/call", name=tool, arguments=arguments)
        except TooSlow:
            raise TooSlow(tool) from None
        self.answered = time.perf_counter()
        took = self.answered - begun
        content = result.get("structuredContent") or result.get("content")
        if result.get("isError"):
            raise RuntimeError(f"{tool}: {json.dumps(content)[:4000]}")
        return content, took

    def kernel_calls(self):
        """How often the kernel was asked since this was asked last; None where that is not logged.

        The server counts from its start on.
        """
        total = None
        until = time.perf_counter() + LATE
        while (left := until - time.perf_counter()) > 0:
            try:
                line = self.log.get(timeout=left)
            except queue.Empty:
                break
            if line is None:
                break
            if found := GEOMETRY.search(COLOUR.sub("", line)):
                total = int(found[1])
        if total is None:
            return None
        calls, self.calls_before = total - self.calls_before, total
        return calls
