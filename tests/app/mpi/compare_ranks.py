#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Compares the command with robochart-verify-mpi on scripts. mpirun starts the latter with two and four ranks of one thread
each, and with two ranks of two threads each. Answers and lengths of counterexamples must be those of the command. States
and transitions must agree too if an assertion holds (if it fails, ranks count whole levels). All numbers and whole
counterexamples must be the same for all numbers of ranks and threads. Exits with 1 if there is a difference."""

import json
import os
import subprocess
import sys
from pathlib import Path

FAILS = 1  # the exit code if an assertion fails, which is the case in these scripts


def decided(command: list[str], scripts: list[str], options: tuple = ()) -> list[dict]:
    """The results of all scripts, without times."""
    environment = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")
    child = subprocess.run(
        [*command, "cspm", *scripts, "--format", "json", "--progress", "never", "--no-cache", *options],
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


def has_colours(mpiexec: str, mpi_program: str, script: str) -> bool:
    """Whether the text that mpirun passes on to a pipe contains escape sequences."""
    environment = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")
    environment.pop("NO_COLOR", None)
    child = subprocess.run([mpiexec, "-n", "1", mpi_program, "cspm", script, "--progress", "never"],
                           capture_output=True, text=True, env=environment, check=False)
    return "\x1b" in child.stdout + child.stderr


def steps(result: dict) -> int:
    """The length of the counterexample; 0 without one."""
    return max((len(each["implementation_behaviour"]["trace"]) for each in result["counterexamples"]), default=0)


def main() -> int:
    program, mpi_program, mpiexec, folder = sys.argv[1:5]
    scripts = sorted(str(path) for path in Path(folder).glob("*.csp"))
    ordinary = decided([program], scripts)
    ways = {(programs, threads): decided([mpiexec, "--oversubscribe", "-n", str(programs), mpi_program], scripts,
                                         ("--threads", str(threads)))
            for programs, threads in ((2, 1), (4, 1), (2, 2))}
    wrong = 0
    for at, expected in enumerate(ordinary):
        place = expected["place"]
        two, *others = (results[at] for results in ways.values())
        same = ["answer", "errors"] + (["visited_states", "visited_transitions", "visited_plys"]
                                       if expected["answer"] == "holds" else [])
        for name in same:
            if two[name] != expected[name]:
                print(f"{place}: {name} is {two[name]} by two ranks, {expected[name]} by the command")
                wrong += 1
        if steps(two) != steps(expected):
            print(f"{place}: the counterexample has {steps(two)} steps by two ranks, {steps(expected)} by the command")
            wrong += 1
        ranks = [each.pop("ranks", 0) for each in (two, *others)]
        wanted = [programs * threads for programs, threads in ways]
        if any(count not in (0, 1, most) for count, most in zip(ranks, wanted)):
            print(f"{place}: the numbers of ranks are {ranks}, at most {wanted} expected")
            wrong += 1
        for other in others:
            if two != other:
                print(f"{place}: by two ranks\n{two}\nby others\n{other}")
                wrong += 1
        print(f"{place}: {expected['answer']}, ranks {ranks}")
    if has_colours(mpiexec, mpi_program, scripts[0]):
        print("colours are printed into a pipe")
        wrong += 1
    print(f"{len(scripts)} scripts, {len(ordinary)} assertions, {wrong} differences")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
