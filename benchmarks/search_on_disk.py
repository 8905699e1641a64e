#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Compares searches with checkpoints, and with states on disk, with the ordinary search (docs/search.md, "Out of core").

Prints for each model the processor time as a ratio of the ordinary search, and the peak memory above that of the program
with its compiled components (the same run, ended after a thousand states), as such a ratio and in bytes per state. For
states on disk it also prints how often all states were read and how often the search rolled back. The minimum processor
time of several alternating rounds counts. Exits with 1 if an answer or a number of states differs in any round, or the
ordinary search gives no answer; with 77 without the models."""

import argparse
import json
import re
import sys
import tempfile
from pathlib import Path

from measured import Child, run


def decide(program: str, script: Path, number: int, *more: str) -> tuple[dict, Child]:
    child = run([program, "cspm", str(script), "--assertion", str(number), "-b", "--format", "json", "--no-cache",
                 "--no-reduction", "--threads", "1", *more])
    try:
        return json.loads(child.output)["results"][0], child
    except (ValueError, LookupError):
        sys.exit(f"{script}: no report:\n{child.errors}")


def measure(options: argparse.Namespace, script: Path, number: int) -> bool:
    """Whether all answers agree."""
    _, least = decide(options.program, script, number, "--max-states", "1000")
    base = least.rss
    whole, first = decide(options.program, script, number)
    if whole["answer"] not in ("holds", "fails"):
        print(f"{script.stem} {number}: the ordinary search gives no answer", file=sys.stderr)
        return False
    states = whole["visited_states"]
    memory = max(first.rss - base, 1)
    limit = base + int(memory / options.part)
    searches = {"ordinary": [], "checkpoints, --every 1000": ["--every", "1000"],
                f"checkpoints, --every {options.every:g}": ["--every", f"{options.every:g}"],
                f"on disk, 1/{options.part:g} of the memory": ["--memory", str(limit)]}
    cpu = {}
    found = {}
    agree = True
    for _ in range(options.rounds):
        for what, more in searches.items():
            with tempfile.TemporaryDirectory() as temporary:
                where = [] if what == "ordinary" else ["--disk" if "disk" in what else "--checkpoint",
                                                       str(Path(temporary) / "kept")]
                result, child = decide(options.program, script, number, *where, *more)
            agree = agree and result["answer"] == whole["answer"]
            agree = agree and (result["answer"] != "holds" or result["visited_states"] == states)
            cpu[what] = min(child.cpu, cpu.get(what, child.cpu))
            rss = max(child.rss, found[what][1] if what in found else 0)
            found[what] = result, rss, child.errors
    for what, (result, rss, errors) in found.items():
        used = max(rss - base, 0)
        ends = re.findall(r"read through (\d+) times, and the search went back (\d+) times", errors) or [("", "")]
        print(f"| {script.stem} {number} | {what} | {result['answer']} | {result['visited_states']:,} | "
              f"{cpu[what] / cpu['ordinary']:.2f} | {used / memory:.2f} | {used / states:.1f} | {rss / states:.1f} | "
              f"{' | '.join(ends[0])} |", flush=True)
    print(f"{script.stem} {number}: ordinary {cpu['ordinary']:.1f} s, {first.rss / 2**20:.1f} MiB, of which "
          f"{base / 2**20:.1f} MiB program and components", file=sys.stderr)
    return agree


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", required=True)
    parser.add_argument("--part", type=float, default=4, help="of the memory of the ordinary search, one in so many")
    parser.add_argument("--every", type=float, default=0.05, help="minutes between checkpoints")
    parser.add_argument("--rounds", type=int, default=1)
    parser.add_argument("models", nargs="+", help="SCRIPT:NUMBER of an assertion")
    options = parser.parse_args()
    print("| model | search | answer | states | CPU, ratio | memory, ratio | bytes a state | with the program | "
          "read through | rolled back |")
    print("| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |")
    agree = True
    for model in options.models:
        name, number = model.rsplit(":", 1)
        if not Path(name).exists():
            print(f"{name} is not there")
            return 77
        agree = measure(options, Path(name), int(number)) and agree
    return 0 if agree else 1


if __name__ == "__main__":
    sys.exit(main())
