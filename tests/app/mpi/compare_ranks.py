#!/usr/bin/env python3
"""Decides scripts with the command and, by 2 and by 4 ranks that mpirun starts, with robochart-verify-mpi, and compares:
answers and lengths of counterexamples are those of the command, states and transitions too where an assertion holds
(where it fails, ranks count whole levels), and all numbers and whole counterexamples are the same for both numbers of
ranks. Exits with 1 where something differs."""

import json
import os
import subprocess
import sys
from pathlib import Path

FAILS = 1  # the exit code where some assertion fails, which is so in these scripts


def decided(command: list[str], scripts: list[str]) -> list[dict]:
    """The results of all scripts, without times."""
    environment = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")
    child = subprocess.run([*command, "cspm", *scripts, "--format", "json", "--progress", "never", "--no-cache"],
                           capture_output=True, text=True, env=environment, check=False)
    if child.returncode != FAILS:
        sys.exit(f"{' '.join(command)}: exit {child.returncode}\n{child.stderr}")
    results = []
    for line in child.stdout.splitlines():
        for result in json.loads(line)["results"]:
            for time in ("seconds", "compile_seconds", "compile_cpu_seconds"):
                del result[time]
            results.append(result)
    return results


def steps(result: dict) -> int:
    """The length of the counterexample; 0 without one."""
    return max((len(each["implementation_behaviour"]["trace"]) for each in result["counterexamples"]), default=0)


def main() -> int:
    program, mpi_program, mpiexec, folder = sys.argv[1:5]
    scripts = sorted(str(path) for path in Path(folder).glob("*.csp"))
    ordinary = decided([program], scripts)
    by_ranks = {count: decided([mpiexec, "--oversubscribe", "-n", str(count), mpi_program], scripts)
                for count in (2, 4)}
    wrong = 0
    for at, expected in enumerate(ordinary):
        place = expected["place"]
        two, four = by_ranks[2][at], by_ranks[4][at]
        same = ["answer", "errors"] + (["visited_states", "visited_transitions", "visited_plys"]
                                       if expected["answer"] == "holds" else [])
        for name in same:
            if two[name] != expected[name]:
                print(f"{place}: {name} is {two[name]} by two ranks, {expected[name]} by the command")
                wrong += 1
        if steps(two) != steps(expected):
            print(f"{place}: the counterexample has {steps(two)} steps by two ranks, {steps(expected)} by the command")
            wrong += 1
        ranks = two.pop("ranks", 0), four.pop("ranks", 0)
        if two != four:
            print(f"{place}: by two ranks\n{two}\nby four\n{four}")
            wrong += 1
        print(f"{place}: {expected['answer']}, ranks {ranks[0]} and {ranks[1]}")
    print(f"{len(scripts)} scripts, {len(ordinary)} assertions, {wrong} differences")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
