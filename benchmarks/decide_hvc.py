#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Decides the assertions of the high-voltage controller, in one process each: from the script that RoboTool wrote for it,
or, with --own, from the script that we generate from its model.

Prints verdict, states, seconds and memory of each assertion next to the recorded figures of FDR. Exits with 1 if a verdict
differs from the recorded one or an assertion is not decided, with 77 without the script. All states are searched. With
--reduction each assertion is also decided with confluent taus followed (docs/search.md); the table then shows the kept
states next to the target, and the share of processor time. With --aims this is done for the assertions with a target, in
both scripts; the exit code is also 1 if more states are kept."""

import argparse
import csv
import json
import sys
import tempfile
from pathlib import Path

from measured import Child, run

# The recorded rows, in the table's order, by the number of their assertion in RoboTool's script and in ours, where the
# reachability assertions come first.
RECORDED = [1, 2, 6, 10, 11, 16]
RECORDED_OWN = [7, 8, 12, 16, 17, 5]
ANSWERS = {"holds": "pass", "fails": "fail"}
# The maximal number of states that the reduction should keep, by the number of the assertion.
AIMED = {6: 90_000, 11: 150_000}
AIMED_OWN = {7: 12_000_000, 12: 150_000, 16: 150_000, 17: 400_000}


def decide(program: str, script: Path, number: int, threads: int, *more: str) -> tuple[dict, Child]:
    """The report on one assertion, and the resources that it took."""
    child = run([program, "cspm", str(script), "--assertion", str(number), "-b", "--format", "json", "--no-cache",
                 "--threads", str(threads), *more])
    sys.stderr.write(child.errors)
    try:
        return json.loads(child.output)["results"][0], child
    except (ValueError, LookupError):
        sys.exit(f"assertion {number}: no report")


def emitted(program: str, folder: Path, out: Path) -> Path:
    """Our own timed script for the model, below `out`."""
    child = run([program, "emit", "csp", str(folder), "--out", str(out), "--quiet"])
    scripts = list(out.glob("csp-gen/timed/*_assertions.csp"))
    if len(scripts) != 1:
        sys.exit(f"no script was written for {folder}:\n{child.errors}")
    files = list(scripts[0].parent.glob("*.csp"))
    print(f"our timed script: {sum(file.stat().st_size for file in files):,} bytes\n")
    return scripts[0]


def search_cpu(result: dict, child: Child) -> float:
    """The processor time of the search, without parsing and compilation."""
    return child.cpu - result["compile_cpu_seconds"]


def reduced_agrees(options: argparse.Namespace, script: Path, number: int, whole: dict, took: Child) -> bool:
    """Prints a row of the table; returns whether the answer is the same and the target is reached."""
    result, child = decide(options.program, script, number, options.threads)
    aimed = (AIMED_OWN if options.own else AIMED).get(number)
    beside = f"{result['chased_states']:,} chased" + (f", aim {aimed:,}" if aimed else "")
    search = f"{search_cpu(result, child) / max(search_cpu(whole, took), 0.01):.2f}"
    print(f"| {number} | reduced: {beside}; CPU {child.cpu / max(took.cpu, 0.01):.2f} of the row above, "
          f"{search} without compilation | {result['answer']} | | {result['visited_states']:,} | | {child.wall:.1f} | "
          f"{child.cpu:.1f}, search {search_cpu(result, child):.1f} | {child.rss >> 20} | |", flush=True)
    reached = not options.aims or result["visited_states"] <= aimed
    return result["answer"] == whole["answer"] and reached


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", required=True)
    parser.add_argument("--folder", type=Path, required=True, help="with FDR-RECORDED.tsv and robotool-csp/")
    parser.add_argument("--threads", type=int, default=0, help="0: as many as there are cores")
    parser.add_argument("--own", action="store_true", help="from the model, through our own script")
    parser.add_argument("--reduction", action="store_true", help="once more without what confluent taus lead on from")
    parser.add_argument("--aims", action="store_true", help="what is aimed at, in both scripts, with --reduction")
    parser.add_argument("numbers", type=int, nargs="*", help="assertions, counted from 1; default: all")
    options = parser.parse_args()
    script = options.folder / "robotool-csp" / "properties_assertions.csp"
    if not script.exists():
        print(f"{script} is not there: nothing to decide")
        return 77
    with tempfile.TemporaryDirectory() as out:
        if options.aims:
            options.reduction = True
        wrong = 0
        for own in (False, True) if options.aims else (options.own,):
            options.own = own
            if own:
                script = emitted(options.program, options.folder, Path(out))
            if options.aims:
                options.numbers = sorted(AIMED_OWN if own else AIMED)
            wrong |= decide_all(options, script)
        return wrong


def decide_all(options: argparse.Namespace, script: Path) -> int:
    """Prints the table; returns the exit status."""
    with open(options.folder / "FDR-RECORDED.tsv") as table:
        rows = csv.DictReader(table, delimiter="\t")
        recorded = dict(zip(RECORDED_OWN if options.own else RECORDED, rows, strict=True))
    print("|  n | assertion | verdict | FDR | states | FDR's states | wall s | CPU s | MiB | FDR: compile + explore s |")
    print("| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |")
    wrong = 0
    for number in options.numbers or range(1, 18):
        result, child = decide(options.program, script, number, options.threads, "--no-reduction")
        row = recorded.get(number, {})
        text = " ".join(result["assertion_string"].split())
        text = text if len(text) <= 60 else text[:57] + "..."
        answer = result["answer"]
        if answer not in ANSWERS or (row and row["verdict"] != ANSWERS[answer]):
            wrong += 1
        took = f"{row['compile_s']} + {row['explore_s']}" if row else ""
        print(f"| {number} | `{text}` | {answer} | {row.get('verdict', '')} | {result['visited_states']:,} | "
              f"{row.get('states', '')} | {child.wall:.1f} | {child.cpu:.1f}, search {search_cpu(result, child):.1f} | "
              f"{child.rss >> 20} | {took} |", flush=True)
        if options.reduction and not reduced_agrees(options, script, number, result, child):
            wrong += 1
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
