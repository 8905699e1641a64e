#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Builds what a benchmark needs in release form, and runs it: benchmarks/run.py NAME [ARGUMENT...].

Without a name it lists the benchmarks. docs/benchmarks.md describes them and has their figures. Files that are not in
the repository are searched for in ../shared, or in the folder ROBOCHART_SHARED."""

import os
import subprocess
import sys
from dataclasses import dataclass, field
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
SHARED = Path(os.environ.get("ROBOCHART_SHARED", ROOT.parent / "shared"))
BUILD = ROOT / "build/release"
PROGRAM = str(BUILD / "app/robochart-verify")
KERNELS = BUILD / "benchmarks"


@dataclass
class Benchmark:
    title: str
    command: list[str]  # the caller's arguments follow
    targets: list[str] = field(default_factory=list)  # in addition to the command robochart-verify
    default: list[str] = field(default_factory=list)  # arguments if the caller gives none
    enki: bool = False  # the simulator Enki takes part


def script(name: str, *arguments: object) -> list[str]:
    return [sys.executable, f"benchmarks/{name}", "--program", PROGRAM, *map(str, arguments)]


def if_there(option: str, folder: Path) -> list[str]:
    return [option, str(folder)] if folder.is_dir() else []


BENCHMARKS = {
    "again": Benchmark("the high-voltage controller again after small edits, with cached results",
                       script("check_again.py", "--folder", SHARED / "bench/hvc")),
    "artifact": Benchmark("every table of docs/benchmarks.md that the repository alone can measure",
                          [sys.executable, "benchmarks/artifact.py"],
                          [f"benchmark_{each}" for each in ("controllers", "checker", "prism", "markov", "frontend",
                                                            "lsp", "simulation")], enki=True),
    "certify": Benchmark("certificates compared with a search without reductions: time and memory",
                         script("certify.py", "--certifier", BUILD / "checker/certify/certifier/robochart-certify",
                                *if_there("--hvc", SHARED / "bench/hvc")), ["robochart_certifier"]),
    "checker": Benchmark("the checker compared with other tools, on the models of benchmarks/models",
                         script("compare_checkers.py", *if_there("--foreign", SHARED / "bench/models"))),
    "claims": Benchmark("claims about robots, all together, with a fine time unit, and about cycles",
                        script("decide_claims.py", "--folder", SHARED / "suite/claims",
                               *if_there("--hvc", SHARED / "bench/hvc"))),
    "code": Benchmark("generated code compared with hand-written nested switches",
                      [sys.executable, "benchmarks/bench_code.py", PROGRAM], default=["60", "g++", "auto"]),
    "components": Benchmark("deadlock, divergence and determinism of every component of RoboTool's scripts",
                            script("decide_components.py", "--scripts", SHARED / "suite/robotool-csp", "--typecheck",
                                   SHARED / "bench/hvc/robotool-csp/properties_assertions.csp")),
    "data": Benchmark("models with data and with many events, compared with another build: run.py data PROGRAM",
                      script("compare_data.py", "--folder", SHARED / "suite/data", "--before")),
    "diagrams": Benchmark("the time to draw diagrams, and crossings compared with ELK's layered layout",
                          ["benchmarks/diagrams.sh", str(KERNELS / "benchmark_diagrams"), str(SHARED)], ["benchmark_diagrams"]),
    "disk": Benchmark("searches with checkpoints and with states on disk", script("search_on_disk.py"),
                      default=[str(SHARED / "bench/models/phils8.csp:1"), str(SHARED / "bench/models/milner18.csp:1")]),
    "events": Benchmark("conformance of a robot with more and more events", script("conform_events.py")),
    "figures": Benchmark("figures about the code base and its build", [sys.executable, "benchmarks/code_figures.py"]),
    "hvc": Benchmark("the high-voltage controller's assertions, compared with the recorded answers of FDR",
                     script("decide_hvc.py", "--folder", SHARED / "bench/hvc")),
    "monitor": Benchmark("the cost that a monitor adds to a robot's step",
                         [str(KERNELS / "benchmark_monitor")], ["benchmark_monitor"],
                         ["25", "corpus/aggregation/aggregation.scenario", "corpus/swarm_taxis/swarm_taxis.scenario"]),
    "pages": Benchmark("the page with the high-voltage controller's counterexample, in Chromium",
                       ["benchmarks/pages.sh", PROGRAM, str(SHARED / "bench/hvc")]),
    "qvbs": Benchmark("the Quantitative Verification Benchmark Set, compared with its values",
                      script("decide_qvbs.py", "--folder", SHARED / "suite/prism/qvbs")),
    "ranks": Benchmark("level searches with threads as ranks: critical path, messages, memory",
                       ["benchmarks/ranks.sh", PROGRAM, str(KERNELS / "benchmark_ranks"), str(SHARED / "bench")],
                       ["benchmark_ranks"]),
    "reduction": Benchmark("what the partial-order reduction costs where it gains nothing", script("reduction_cost.py")),
    "rules": Benchmark("a SLEEC rule about a model, and in SLEEC-TK's published encoding", script("decide_rules.py")),
    "scripts": Benchmark("bytes and states of our scripts, compared with RoboTool's published scripts",
                         script("compare_scripts.py", "--scripts", SHARED / "suite/robotool-csp")),
    "simulation": Benchmark("robot steps per CPU second of the embedded world and of Enki",
                            [str(BUILD / "simulation/adapters/enki/benchmark_simulation")], ["benchmark_simulation"],
                            ["corpus/aggregation/aggregation.scenario"], enki=True),
    "swarms": Benchmark("claims about swarms", script("decide_swarms.py")),
    "tuning": Benchmark("swarm taxis tuned, compared with the paper's values and with irace",
                        [sys.executable, "benchmarks/tune_taxis.py"]),
    "uvc": Benchmark("the probabilities of the UVC case study, compared with the reference",
                     script("decide_uvc.py", "--folder", SHARED / "suite/prism/uvc")),
    "wide": Benchmark("networks of many parts, whose states are too many to be stored", script("decide_wide.py")),
    "windows": Benchmark("a cycle of generated code that folds three windows of a laser scan",
                         [sys.executable, "benchmarks/scan_windows.py", PROGRAM]),
}


def build(benchmark: Benchmark) -> None:
    options = ["-DROBOCHART_BENCHMARKS=ON"] if benchmark.targets else []
    options += ["-DROBOCHART_WITH_ENKI=ON"] if benchmark.enki else []
    if benchmark.targets:
        subprocess.run(["scripts/setup.sh", "benchmarks"], cwd=ROOT, check=True)
    subprocess.run(["cmake", "--preset", "release", *options], cwd=ROOT, check=True, stdout=subprocess.DEVNULL)
    subprocess.run(["cmake", "--build", "--preset", "release", "--target", "robochart-verify", *benchmark.targets],
                   cwd=ROOT, check=True)


def main() -> int:
    name, arguments = (sys.argv[1], sys.argv[2:]) if len(sys.argv) > 1 else ("", [])
    if name not in BENCHMARKS:
        if name:
            print(f"no benchmark is called {name}", file=sys.stderr)
        for each, benchmark in BENCHMARKS.items():
            print(f"{each:<12}{benchmark.title}")
        return 1 if name else 0
    benchmark = BENCHMARKS[name]
    build(benchmark)
    return subprocess.run([*benchmark.command, *(arguments or benchmark.default)], cwd=ROOT).returncode


if __name__ == "__main__":
    sys.exit(main())
