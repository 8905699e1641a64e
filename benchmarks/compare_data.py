#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Compares two builds of the command on models with data and on models with many events.

Usage: benchmarks/compare_data.py --program PROGRAM --before PROGRAM --folder FOLDER [ROW...]
       benchmarks/run.py data PROGRAM [ROW...]
`--before` is the build to compare with, such as the one before classes of data, commit 9aa2154c. `--folder` contains the
models of suite/data. Each row runs both builds, one after the other, as many times as --runs says, and prints the median
of the CPU time. A run of the other build ends after --limit seconds of CPU time; it is then not repeated. Exits with 1 if
a row misses its target, with 77 without the models."""

import argparse
import json
import os
import statistics
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path
from typing import Optional

import conform_events
import measured

ROOT = Path(__file__).resolve().parent.parent


@dataclass
class Row:
    name: str
    command: list[str]
    ratio: Optional[float] = None  # the maximal share of the CPU time of the other build
    states: Optional[int] = None  # the maximal number of states; with `no_more_states`, the other build's
    no_more_states: bool = False
    seconds: Optional[float] = None  # the maximal CPU time; the other build is then not run
    needs: Optional[Path] = None


@dataclass
class Result:
    cpu: float
    states: int
    outcome: str


def states_and_outcome(output: str) -> tuple[int, str]:
    """The largest number of states of an answer, and the numbers of the answers of each kind."""
    try:
        report = json.loads(output)
    except ValueError:
        return 0, "no report"
    parts = report.get("conformance", [])
    if parts:
        return max(part.get("codeStates", 0) for part in parts), parts[0].get("outcome", "")
    answers = [claim["answer"] for claim in report["assertions"]]
    states = [claim.get("statistics", {}).get("states", 0) for claim in report["assertions"]]
    kinds = sorted(set(answers))
    return max(states, default=0), ", ".join(f"{answers.count(kind)} {kind}" for kind in kinds)


def run_once(program: str, row: Row, limit: int) -> Result:
    command = [program, *row.command, "--format", "json", "--no-cache", "--threads", "1"]
    if limit:
        command = ["prlimit", f"--cpu={limit}", *command]
    child = measured.run(command)
    states, outcome = states_and_outcome(child.output)
    return Result(child.cpu, states, outcome)


def median(results: list[Result]) -> Result:
    return Result(statistics.median(result.cpu for result in results), results[-1].states, results[-1].outcome)


def compare(options: argparse.Namespace, row: Row) -> bool:
    """Prints the row; returns whether its target is met."""
    before: list[Result] = []
    after: list[Result] = []
    for _ in range(options.runs):
        if row.seconds is None and not (before and before[-1].cpu >= options.limit - 1):
            before.append(run_once(options.before, row, options.limit))
        after.append(run_once(options.program, row, 0))
    new = median(after)
    met = True
    cells = ["", "", ""]
    if before:
        old = median(before)
        share = new.cpu / old.cpu
        cells = [f"{old.outcome}", f"{old.states:,}", f"{old.cpu:.2f}"]
        met = row.ratio is None or share <= row.ratio
        met = met and not (row.no_more_states and new.states > old.states)
    met = met and (row.states is None or new.states <= row.states)
    met = met and (row.seconds is None or new.cpu <= row.seconds)
    ratio = f"{share:.3f}" if before else ""
    target = f"{row.ratio:g}" if row.ratio is not None else f"{row.seconds:g} s"
    print(f"| {row.name} | {' | '.join(cells)} | {new.outcome} | {new.states:,} | {new.cpu:.2f} | {ratio} | {target} | "
          f"{'yes' if met else 'no'} |", flush=True)
    return met


def rows_of(options: argparse.Namespace, temporary: Path) -> list[Row]:
    def trolley(events: int) -> str:
        folder = temporary / f"events{events}"
        folder.mkdir()
        (folder / "trolley.rct").write_text(conform_events.model_text(events))
        return str(folder)

    def model(name: str) -> list[str]:
        return [str(options.folder / name)]

    hvc = options.folder.parent.parent / "bench/hvc"
    rows = [
        Row("swarm_taxis", ["check", str(ROOT / "corpus/swarm_taxis")], 1.05, no_more_states=True),
        Row("priority_relay", ["check", *model("priority_relay")], 1 / 20, states=100),
        Row("twist_constants", ["check", *model("twist_constants")], 0.15),
        Row("events8", ["conform", trolley(8), "--component", "Trolley"], 1 / 5),
        Row("events16", ["conform", *model("events16"), "--component", "Warehouse"], 1 / 20),
        Row("events30", ["conform", *model("events30"), "--component", "Warehouse"], seconds=60),
        Row("hvc", ["check", str(hvc)], 1.05, no_more_states=True, needs=hvc),
    ]
    wanted = [row for row in rows if not options.rows or row.name in options.rows]
    return [row for row in wanted if row.needs is None or row.needs.is_dir()]


def more_events(options: argparse.Namespace, temporary: Path) -> bool:
    """12 events against 8, with the same build."""
    times = []
    for events in (8, 12):
        folder = temporary / f"more{events}"
        folder.mkdir()
        (folder / "trolley.rct").write_text(conform_events.model_text(events))
        row = Row("", ["conform", str(folder), "--component", "Trolley"])
        times.append(median([run_once(options.program, row, 0) for _ in range(options.runs)]).cpu)
    share = times[1] / times[0]
    print(f"\n12 events take {times[1]:.2f} s of CPU time, {share:.2f} times as long as 8 events ({times[0]:.2f} s); "
          f"the target is 4 times")
    return share <= 4


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", required=True)
    parser.add_argument("--before", required=True, help="the program of the other build")
    parser.add_argument("--folder", type=Path, required=True, help="with the models of suite/data")
    parser.add_argument("--runs", type=int, default=3)
    parser.add_argument("--limit", type=int, default=300, help="seconds of CPU time for a run of the other build")
    parser.add_argument("rows", nargs="*", help="the rows to measure; default: all, and 12 events against 8")
    options = parser.parse_args()
    if not options.folder.is_dir():
        print(f"{options.folder} is not there: nothing to compare")
        return 77
    print(f"load: {os.getloadavg()[0]:.1f}\n")
    print("| model | before | states | CPU s | now | states | CPU s | share | target | met |")
    print("| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |")
    with tempfile.TemporaryDirectory() as folder:
        met = [compare(options, row) for row in rows_of(options, Path(folder))]
        if not options.rows:
            met.append(more_events(options, Path(folder)))
    print(f"\nload: {os.getloadavg()[0]:.1f}")
    return 0 if all(met) else 1


if __name__ == "__main__":
    sys.exit(main())
