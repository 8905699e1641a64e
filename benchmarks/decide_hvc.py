#!/usr/bin/env python3
"""Decides the assertions of the high-voltage controller's script, as RoboTool wrote it, one program each.

Prints verdict, states, seconds and memory of each beside what was recorded of FDR; exits with 1 if a verdict differs
from the recorded one or an assertion is not decided, with 77 without the script."""

import argparse
import csv
import json
import os
import subprocess
import sys
import time
from pathlib import Path

# The recorded rows, in the table's order, by the number of their assertion in the script.
RECORDED = [1, 2, 6, 10, 11, 16]
ANSWERS = {"holds": "pass", "fails": "fail"}


def run(program: str, script: Path, number: int, threads: int) -> tuple[dict, float, float, int]:
    """The report on one assertion, wall and CPU seconds, and peak memory in MiB."""
    start = time.monotonic()
    command = [program, "cspm", str(script), "--assertion", str(number), "-b", "--format", "json"]
    child = subprocess.Popen(command + ["--threads", str(threads)], stdout=subprocess.PIPE, text=True)
    report = child.stdout.read()
    _, _, usage = os.wait4(child.pid, 0)
    wall = time.monotonic() - start
    try:
        result = json.loads(report)["results"][0]
    except (ValueError, LookupError):
        sys.exit(f"assertion {number}: no report")
    return result, wall, usage.ru_utime + usage.ru_stime, usage.ru_maxrss // 1024


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", required=True)
    parser.add_argument("--folder", type=Path, required=True, help="with FDR-RECORDED.tsv and robotool-csp/")
    parser.add_argument("--threads", type=int, default=0, help="0: as many as there are cores")
    parser.add_argument("numbers", type=int, nargs="*", help="assertions, counted from 1; default: all")
    options = parser.parse_args()
    script = options.folder / "robotool-csp" / "properties_assertions.csp"
    if not script.exists():
        print(f"{script} is not there: nothing to decide")
        return 77
    with open(options.folder / "FDR-RECORDED.tsv") as table:
        recorded = dict(zip(RECORDED, csv.DictReader(table, delimiter="\t"), strict=True))
    print("|  n | assertion | verdict | FDR | states | FDR's states | wall s | CPU s | MiB | FDR: compile + explore s |")
    print("| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |")
    wrong = 0
    for number in options.numbers or range(1, 18):
        result, wall, cpu, memory = run(options.program, script, number, options.threads)
        row = recorded.get(number, {})
        text = " ".join(result["assertion_string"].split())
        text = text if len(text) <= 60 else text[:57] + "..."
        answer = result["answer"]
        if answer not in ANSWERS or (row and row["verdict"] != ANSWERS[answer]):
            wrong += 1
        took = f"{row['compile_s']} + {row['explore_s']}" if row else ""
        print(f"| {number} | `{text}` | {answer} | {row.get('verdict', '')} | {result['visited_states']:,} | "
              f"{row.get('states', '')} | {wall:.1f} | {cpu:.1f} | {memory} | {took} |", flush=True)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
