#!/usr/bin/env python3
"""Decides the claims of benchmarks/models/grid.swarm about robots of corpus/alpha, for numbers of robots and sizes of the
grid. Prints a line for each claim: its answer, the states that were searched, and what the run of all claims took. Exits
with 1 where a claim is not decided, with 3 where the program does not answer or nothing was asked."""

import argparse
import json
import sys

from measured import run


def decide(program: str, robots: int, side: int, claims: list[str], timeout: int) -> int:
    command = [program, "check", "corpus/alpha", "--swarm", "benchmarks/models/grid.swarm", "--allow", "RC-S17",
               "--robots", str(robots), "--grid", f"{side}x{side}", "--threads", "1", "--no-cache", "--format", "json",
               "--timeout", str(timeout)]
    for claim in claims:
        command += ["--assertion", claim]
    child = run(command)
    try:
        report = json.loads(child.output)
    except json.JSONDecodeError:
        print(child.said(), file=sys.stderr)
        return 3
    if not report["assertions"]:
        print(f"{robots} robots, {side}x{side}: nothing was asked", file=sys.stderr)
        return 3
    for each in report["assertions"]:
        print(f"{robots} robots, {side}x{side}: {each['answer']:<12} {each['statistics']['states']:>10,} states  "
              f"{each['title']}")
    print(f"{robots} robots, {side}x{side}: {child.cpu:.1f} CPU s, {child.rss / 2**20:.0f} MiB", flush=True)
    return 1 if any(each["answer"] not in ("holds", "fails") for each in report["assertions"]) else 0


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", default="build/release/app/robochart-verify")
    parser.add_argument("--sizes", nargs="+", default=["3x8"], help="ROBOTSxSIDE, such as 3x16")
    parser.add_argument("--assertion", action="append", default=[], help="a claim, as it is written in the file")
    parser.add_argument("--timeout", type=int, default=1800, help="seconds for each size")
    options = parser.parse_args()
    worst = 0
    for size in options.sizes:
        robots, side = (int(each) for each in size.split("x"))
        worst = max(worst, decide(options.program, robots, side, options.assertion, options.timeout))
    return worst


if __name__ == "__main__":
    sys.exit(main())
