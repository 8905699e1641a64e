#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Measures the tables of docs/benchmarks.md and prints each next to the table of the document.

A table that needs files which are not in the repository is not measured: its line says which files, and where the public
originals are. Exits with 1 if a measurement fails, that is, if its
program finds a wrong answer or a wrong number of states."""

import argparse
import re
import subprocess
import sys
import time
from dataclasses import dataclass, field
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
BUILD = ROOT / "build/release"
PROGRAM = BUILD / "app/robochart-verify"
KERNELS = BUILD / "benchmarks"
PYTHON = sys.executable


@dataclass
class Table:
    heading: str  # of the section of docs/benchmarks.md, without the number signs
    commands: list[list[str]] = field(default_factory=list)
    needs: str = ""  # the files that are not in the repository


def script(name: str, *arguments: str) -> list[str]:
    return [PYTHON, f"benchmarks/{name}", *arguments]


def tables(quick: bool) -> list[Table]:
    shared = "../shared, or ROBOCHART_SHARED"
    return [
        Table("Benchmarks", [[str(KERNELS / name), "--benchmark_min_time=0.5"]
                             for name in ("benchmark_controllers", "benchmark_checker", "benchmark_prism")]),
        Table("Data compared with an earlier build", needs=f"{shared}, and another build of the command"),
        Table("Probabilities", [[str(KERNELS / "benchmark_markov"), "60"]]),
        Table("Published models", needs=f"{shared}; the originals: UoY-RoboStar/uvc-case-study on GitHub, and the "
                                        "Quantitative Verification Benchmark Set, ahartmanns/qcomp on GitHub"),
        Table("The front end", [[str(KERNELS / "benchmark_frontend")]]),
        Table("A keystroke in an editor", [[str(KERNELS / "benchmark_lsp")]]),
        Table("The checker compared with other tools",
              [script("compare_checkers.py", "--program", str(PROGRAM), *(["--quick"] if quick else []))]),
        Table("What the reduction costs", [script("reduction_cost.py", "--program", str(PROGRAM), "--repeat", "1")]),
        Table("Components of RoboTool's scripts", needs=f"{shared}: scripts that RoboTool wrote; robostar.cs.york.ac.uk has its examples"),
        Table("Scripts compared with RoboTool's", needs=f"{shared}: the same scripts"),
        Table("The high-voltage controller", needs=f"{shared}; the original: UoY-RoboStar/hvc-case-study on GitHub"),
        Table("Rules about a model",
              [script("decide_rules.py", "--program", str(PROGRAM), "--values", values, "--limit", "1000000")
               for values in ("8", "20")]),
        Table("Again, after an edit", needs=f"{shared}: the high-voltage controller"),
        Table("Diagrams", needs=f"{shared}, and elkjs from the npm registry: benchmarks/run.py diagrams"),
        Table("Simulation", [[str(BUILD / "simulation/adapters/enki/benchmark_simulation"),
                              "corpus/aggregation/aggregation.scenario"]]),
        Table("Latency of ROS 2 nodes", [script("ros2_latency.py", str(PROGRAM))]),
        Table("The code base and its build", [["python3", "benchmarks/code_figures.py"]]),
    ]


def documented(heading: str) -> str:
    """The tables of a section of the document."""
    text = (ROOT / "docs/benchmarks.md").read_text()
    found = re.search(rf"^#+ {re.escape(heading)}\n(.*?)(?=^#+ |\Z)", text, flags=re.M | re.S)
    if not found:
        sys.exit(f"docs/benchmarks.md has no section '{heading}'")
    rows = [line for line in found[1].splitlines() if line.startswith("|")]
    return "\n".join(rows)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--only", default="", help="only sections whose heading contains this")
    parser.add_argument("--quick", action="store_true", help="omit models of more than a million states")
    options = parser.parse_args()
    failed = []
    for table in tables(options.quick):
        if options.only.lower() not in table.heading.lower():
            continue
        print(f"\n== {table.heading}", flush=True)
        expected = documented(table.heading)
        if table.needs:
            print(f"not measured, needs {table.needs}")
            continue
        for command in table.commands:
            start = time.monotonic()
            shown = " ".join(word.replace(str(ROOT) + "/", "") for word in command[0 if command[0] != PYTHON else 1:])
            print(f"$ {shown}", flush=True)
            status = subprocess.run(command, cwd=ROOT, stderr=subprocess.STDOUT).returncode
            print(f"({time.monotonic() - start:.0f} s, exit {status})", flush=True)
            if status not in (0, 77):
                failed.append(shown)
        print(f"docs/benchmarks.md:\n{expected}", flush=True)
    for command in failed:
        print(f"failed: {command}")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
