#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Decides the claims of benchmarks/models/grid.swarm about robots of corpus/alpha, for numbers of robots and sizes of the
grid. Prints a line for each claim: its answer, the number of searched states, and the time and memory of the run. Exits
with 1 if a claim is not decided or has a wrong answer, with 3 if the program does not answer or there was no claim."""

import argparse
import json
import sys

from measured import run


def expected(claim: str, robots: int, side: int) -> str | None:
    """The expected answer to a claim; None: unknown.

    On a torus no two cells are more than side // 2 apart, so robots are always linked over three cells up to side 7, and
    never three cells away up to side 5. On larger tori, robots that hear each other continue with one heading, as far as the
    torus allows. Robots that lose each other drive straight ahead, in parallel or apart, forever (published for the same
    algorithm: a robot may lose contact, and robots that drive straight need not meet again)."""
    if robots != 3 or side < 4:
        return None
    if claim == "deadlock free":
        return "holds"
    if claim == "always linked(3)":
        return "holds" if side <= 7 else "fails"
    if claim == "recurrent linked(1)":
        return "fails"
    if claim == "possible linked(1) and away(3)":
        return "holds" if side >= 6 else "fails"
    return None


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
    right = True
    for each in report["assertions"]:
        claim = each["title"].removeprefix("Grid: ").split(" [")[0]
        wanted = expected(claim, robots, side)
        wrong = wanted is not None and each["answer"] != wanted
        note = f": expected {wanted}" if wrong else "" if wanted else ": no answer is expected"
        right = right and not wrong and each["answer"] in ("holds", "fails")
        print(f"{robots} robots, {side}x{side}: {each['answer']:<12} {each['statistics']['states']:>10,} states  "
              f"{each['title']}{note}")
    print(f"{robots} robots, {side}x{side}: {child.cpu:.1f} CPU s, {child.rss / 2**20:.0f} MiB", flush=True)
    return 0 if right else 1


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
