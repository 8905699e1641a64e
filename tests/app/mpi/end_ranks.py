#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Ends distributed searches in every documented way: an error of one rank, limits, signals to mpirun (docs/scale.md). Checks
that all ranks end, with the documented exit code and message. Exits with 1 if there is a difference. With --sample it
tries only some of the ways.

    end_ranks.py MPIEXEC PROGRAM FAULTY_RANKS [--sample]"""

import os
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

SCRIPT = """channel a, b, c, d : {0..11}
P(i) = a.i -> b.i -> c.i -> d.i -> P(i)
assert ||| i : {0..11} @ P(i) :[deadlock free [F]]
"""  # 4^12 states
FEW = "assert (a.0 -> STOP) ||| (a.1 -> STOP) :[divergence free]\nchannel a : {0..1}\n"
HOLDS, INTERNAL, INCONCLUSIVE, USAGE = 0, 70, 3, 4


def ranks_left(folder: str) -> list[str]:
    """Ranks that still run: processes with the script of this run, a file in the folder, among their
    arguments."""
    found = []
    for entry in Path("/proc").iterdir():
        try:
            words = (entry / "cmdline").read_bytes() if entry.name.isdigit() else b""
        except OSError:
            continue
        if folder.encode() in words and entry.name != str(os.getpid()):
            found.append(entry.name)
    return found


class Ends:
    def __init__(self, mpiexec: str, program: str, faulty: str, folder: str):
        self.mpiexec, self.program, self.faulty, self.folder = mpiexec, program, faulty, folder
        self.wrong = 0

    def run(self, what: str, arguments: list[str], codes: set[int], words: str, *, after: int = 0) -> None:
        """`after`: the signal that mpirun gets after the search has started; 0: none."""
        environment = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
                           TMPDIR=self.folder)
        child = subprocess.Popen([self.mpiexec, "--oversubscribe", "-n", "3", *arguments, "--no-cache"],
                                 stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, env=environment)
        output = ""
        if after:
            while "searching" not in (line := child.stdout.readline()) and line:
                output += line
            child.send_signal(after)
        try:
            output += child.communicate(timeout=60)[0]
        except subprocess.TimeoutExpired:
            child.kill()
            output += "(it did not end)"
        right = child.returncode in codes and output.count(words) == 1
        # Ranks that mpirun ends may need a moment to exit.
        limit = time.monotonic() + 5
        while ranks_left(self.folder) and time.monotonic() < limit:
            time.sleep(0.05)
        left = ranks_left(self.folder)
        if not right or left:
            self.wrong += 1
            print(f"{what}: exit {child.returncode}, {sorted(codes)} expected, with `{words}`; left: {left}\n{output}")
        else:
            print(f"{what}: exit {child.returncode}")


def limits_and_refusals(ends: Ends, program: str, many: str, few: str) -> None:
    ends.run("--timeout", [program, "cspm", many, "--no-reduction", "--timeout", "1"], {INCONCLUSIVE},
             "the time limit was reached")
    ends.run("--max-states", [program, "cspm", many, "--no-reduction", "--max-states", "2000"], {INCONCLUSIVE},
             "the limit of 2000 states was reached")
    ends.run("--threads", ["taskset", "-c", "0", program, "cspm", few, "--threads", "2"], {HOLDS}, "2 threads share 1 core")


def main() -> int:
    mpiexec, program, faulty = sys.argv[1:4]
    sample = "--sample" in sys.argv[4:]
    with tempfile.TemporaryDirectory() as folder:
        many, few = os.path.join(folder, "many.csp"), os.path.join(folder, "few.csp")
        Path(many).write_text(SCRIPT)
        Path(few).write_text(FEW)
        ends = Ends(mpiexec, program, faulty, folder)
        for number, threads in (("2", "2"),) if sample else (("0", "1"), ("0", "2"), ("2", "1"), ("2", "2")):
            who = "" if number == "0" else f"program {number}: "
            asked = ["cspm", many, "--threads", threads]
            ends.run(f"an error of program {number}, {threads} threads", [faulty, number, "5", "error", *asked],
                     {INTERNAL}, f"{'an internal error: ' if number == '0' else who}an injected error")
            if sample:
                continue
            ends.run(f"no memory in program {number}, {threads} threads", [faulty, number, "5", "memory", *asked],
                     {INCONCLUSIVE}, f"{who}there is no more memory")
        if not sample:
            limits_and_refusals(ends, program, many, few)
        searching = [program, "cspm", many, "--no-reduction", "--progress", "json"]
        # After an interrupt, mpirun exits with its own exit code.
        for name in ("SIGTERM",) if sample else ("SIGINT", "SIGTERM"):
            for threads in ("2",) if sample else ("1", "2"):
                ends.run(f"{name} to mpirun, {threads} threads", [*searching, "--threads", threads], {1, INCONCLUSIVE},
                         "the run was interrupted", after=getattr(signal, name))
        return 1 if ends.wrong else 0


if __name__ == "__main__":
    sys.exit(main())
