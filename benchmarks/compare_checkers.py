#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Generates the state spaces of benchmarks/models with our checker, and compares with the figures of mCRL2, LTSmin and SPIN
that benchmarks/models/peers.tsv records. With --foreign FOLDER the installed tools also run, on MODEL.mcrl2 and
MODEL.pml in the folder.

Prints a table; exits with 1 if a count of states or transitions differs from the recorded one."""

import argparse
import csv
import json
import re
import shutil
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path
from typing import Optional

from measured import run

SMALL = ["phils7", "milner15", "cbuf10", "buf12"]
LARGE = ["cbuf11", "phils8", "milner18"]
MODELS = Path(__file__).parent / "models"
# Scripts below MODELS; their first definition is N.
SCRIPTS = {"phils": "philosophers.csp", "milner": "scheduler.csp", "cbuf": "cells.csp", "buf": "buffers.csp"}
# Models without a row in peers.tsv: 3^12 states, confirmed by mCRL2.
COUNTS = {"buf12": (531441, 2007666)}


@dataclass
class Run:
    """The run of one program on one model."""
    tool: str
    states: int
    transitions: int
    wall: float
    cpu: float
    rss: int  # bytes

    def rate(self) -> float:
        """Million transitions per CPU second."""
        return self.transitions / max(self.cpu, 1e-3) / 1e6


class Ours:
    def __init__(self, program: str, folder: str):
        self.program, self.folder = program, folder
        help_text = subprocess.run([program, "cspm", "--help"], capture_output=True, text=True, check=True).stdout
        self.has_threads = "--threads" in help_text
        self.all_states = ["--no-reduction"] if "--no-reduction" in help_text else []
        empty = Path(folder, "empty.csp")
        empty.write_text("assert SKIP [T= STOP\n")
        self.base = run([program, "cspm", str(empty)], folder).rss

    def explore(self, model: str, threads: int) -> Run:
        """Explores all states: deadlock freedom holds, so the search visits all of them."""
        family, size = re.fullmatch(r"([a-z]+)(\d+)", model).groups()
        text = (MODELS / SCRIPTS[family]).read_text()
        script = Path(self.folder, model + ".csp")
        script.write_text(re.sub(r"^N = \d+", f"N = {size}", text, flags=re.M))
        command = [self.program, "cspm", str(script), "--format", "json", "--progress", "never", "--no-cache",
                   *self.all_states]
        if self.has_threads:
            command += ["--threads", str(threads)]
        child = run(command, self.folder)
        try:
            result = json.loads(child.output)["results"][0]
        except (ValueError, LookupError):
            sys.exit(f"{' '.join(command)}: exit {child.exit}\n{child.said()}")
        if result["result"] != 1:
            sys.exit(f"{model}: our checker says {result['answer']} {result['errors']}")
        return Run(f"ours, {threads} thread{'s' if threads > 1 else ''}", result["visited_states"],
                   result["visited_transitions"], child.wall, child.cpu, child.rss)


def numbers(pattern: str, text: str) -> Optional[tuple[int, int]]:
    found = re.search(pattern, text)
    return (int(found[1].replace(",", "")), int(found[2].replace(",", ""))) if found else None


def mcrl2(model: Path, folder: str) -> Optional[Run]:
    source = model.with_suffix(".mcrl2")
    if not source.exists():
        return None
    lps = str(Path(folder, "model.lps"))
    first = run(["mcrl22lps", str(source), lps], folder)
    second = run(["lps2lts", "--cached", "-rjittyc", "--verbose", lps], folder)
    counts = numbers(r"(\d+) states and (\d+) transitions", second.said())
    if first.exit or second.exit or counts is None:
        return None
    return Run("mCRL2 (live)", *counts, first.wall + second.wall, first.cpu + second.cpu, second.rss)


def ltsmin(model: Path, folder: str) -> Optional[Run]:
    source = model.with_suffix(".pml")
    if not source.exists():
        return None
    shutil.copy(source, folder)
    compiled = run(["spins", source.name], folder)
    # With two threads, loading sometimes fails (a known assertion); so it uses one thread and two attempts.
    for _ in range(2):
        child = run(["prom2lts-mc", "--threads=1", "--state=tree", "-s26", source.name + ".spins"], folder)
        counts = numbers(r"(\d+) states,? (\d+) transitions", child.said()) or \
            numbers(r"States: (\d+)[\s\S]*?Transitions: (\d+)", child.said())
        if compiled.exit == 0 and child.exit == 0 and counts:
            return Run("LTSmin (live)", *counts, child.wall, child.cpu, child.rss)
    return None


def spin(model: Path, folder: str) -> Optional[Run]:
    source = model.with_suffix(".pml")
    if not source.exists():
        return None
    shutil.copy(source, folder)
    made = run(["spin", "-o3", "-a", source.name], folder)
    built = run(["cc", "-O3", "-DNOREDUCE", "-DSAFETY", "-DMEMLIM=12000", "-o", "pan", "pan.c"], folder)
    child = run(["./pan", "-m20000000", "-w25", "-E", "-c0"], folder)
    counts = numbers(r"(\d+) states, stored[\s\S]*?(\d+) transitions", child.said())
    if made.exit or built.exit or child.exit or counts is None:
        return None
    return Run("SPIN (live)", counts[0], counts[1] - 1, child.wall, child.cpu, child.rss)  # it counts the initial step


PEERS = [("mCRL2", ["mcrl22lps", "lps2lts"], mcrl2), ("LTSmin", ["spins", "prom2lts-mc"], ltsmin),
         ("SPIN", ["spin", "cc"], spin)]


def recorded() -> dict[str, list[Run]]:
    rows: dict[str, list[Run]] = {}
    with open(MODELS / "peers.tsv", newline="") as file:
        for row in csv.DictReader(file, delimiter="\t"):
            rows.setdefault(row["model"], []).append(
                Run(row["tool"] + " (recorded)", int(row["states"]), int(row["transitions"]), float(row["wall_s"]),
                    float(row["cpu_s"]), int(float(row["rss_MB"]) * 1e6)))
    return rows


def expected_counts(model: str, rows: list[Run]) -> tuple[int, int]:
    """The counts of the exact, unreduced explorations: those of LTSmin and mCRL2, which agree (SPIN counts the start as a step)."""
    exact = {(r.states, r.transitions) for r in rows if r.tool.startswith(("ltsmin", "mcrl2"))}
    if model in COUNTS:
        exact.add(COUNTS[model])
    if len(exact) != 1:
        sys.exit(f"{model}: the recorded counts disagree: {exact}")
    return exact.pop()


def best(rows: list[Run], counts: tuple[int, int]) -> Optional[Run]:
    exact = [r for r in rows if r.states == counts[0] and not r.tool.startswith("ltsmin2")]
    return max(exact, key=Run.rate, default=None)


def show(run_: Run, base: int, peer: Optional[Run]) -> None:
    beyond = max(run_.rss - base, 0) / run_.states
    ratio = f"{run_.rate() / peer.rate():6.2f}" if peer else "     -"
    print(f"  {run_.tool:22} {run_.states:>10,} {run_.transitions:>12,} {run_.wall:8.2f} {run_.cpu:8.2f} "
          f"{run_.rate():9.2f} {beyond:8.1f} {run_.rss / 1e6:8.0f} {ratio}")


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", required=True, help="robochart-verify, in release form")
    parser.add_argument("--foreign", type=Path, help="folder of the same models for mCRL2, LTSmin and SPIN")
    parser.add_argument("--quick", action="store_true", help="only models of about a million states or fewer")
    parser.add_argument("names", nargs="*", help="models (default: all)")
    options = parser.parse_args()
    program = str(Path(options.program).resolve())
    peers = recorded()
    wrong = 0
    with tempfile.TemporaryDirectory() as folder:
        ours = Ours(program, folder)
        if not ours.has_threads:
            print("this program has no --threads: one thread only")
        installed = []
        for name, tools, explore in PEERS:
            missing = [tool for tool in tools if shutil.which(tool) is None]
            if options.foreign is None:
                break
            if missing:
                print(f"{name} is not installed ({', '.join(missing)} not on the path): recorded figures only")
            else:
                installed.append((name, explore))
        print(f"  {'':22} {'states':>10} {'transitions':>12} {'wall s':>8} {'CPU s':>8} {'M tr/CPU s':>9} "
              f"{'B/state':>8} {'RSS MB':>8} {'ratio':>6}")
        for model in options.names or SMALL + ([] if options.quick else LARGE):
            rows = peers.get(model, [])
            counts = expected_counts(model, rows)
            runs = [ours.explore(model, threads) for threads in ([1, 2] if ours.has_threads else [1])]
            for name, explore in installed:
                with tempfile.TemporaryDirectory() as place:
                    found = explore(options.foreign / model, place)
                if found is None:
                    print(f"{model}: {name} could not be run on it")
                else:
                    runs.append(found)
            live = [r for r in runs if not r.tool.startswith("ours")]
            peer = best(rows + live, counts)
            print(f"{model}, against {peer.tool if peer else 'nobody'}"
                  + (f" with {peer.rate():.2f} M transitions a CPU second" if peer else ""))
            for done in runs:
                show(done, ours.base if done.tool.startswith("ours") else 0, peer)
                if (done.states, done.transitions) != counts:
                    print(f"  WRONG: {done.tool} counts {done.states} states and {done.transitions} transitions, "
                          f"recorded are {counts[0]} and {counts[1]}")
                    wrong += 1
            if len(runs) > 1 and runs[1].tool.startswith("ours"):
                print(f"  two threads: {runs[0].wall / max(runs[1].wall, 1e-3):.2f} times as fast as one")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
