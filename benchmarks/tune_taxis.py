#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Tunes both radii and the patience of swarm taxis from random starts, with `tune` and, if R has it, with irace at the same
budget of trials, and judges the results and the paper's values on the scenario's own seeds.

Both searches use the same costs: the time until the swarm arrives, or ten times the
scenario's duration. With ten repetitions of each, Wilcoxon's signed-rank test compares the costs on fresh seeds.
"""

import argparse
import csv
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

PARAMETERS = {"nearRadius": ("r", 0.05, 0.5), "farRadius": ("r", 0.05, 0.5), "patience": ("i", 5, 60)}
PAPER = {"nearRadius": "0.1", "farRadius": "0.2", "patience": "25"}
DURATION = 400
PENALTY = 10 * DURATION


def run(command):
    return subprocess.run(command, capture_output=True, text=True, check=False)


def with_constants(constants):
    return [word for name, value in constants.items() for word in ("--const", f"{name}={value}")]


def with_bands(scenario):
    """The scenario with a band in place of its claim, because the JSON then contains the arrival time of each trial."""
    text = scenario.read_text()
    text = re.sub(r"\taccept probability.*", f"\taccept each first(way <= 50 cm) <= {DURATION} s", text)
    bands = scenario.with_name("bands.scenario")
    bands.write_text(text)
    return bands


def costs(program, bands, constants, seed, trials):
    answer = run([program, "simulate", str(bands), "--no-pictures", "--format", "json", "--seed", str(seed),
                  "--trials", str(trials), *with_constants(constants)])
    times = json.loads(answer.stdout)["bands"][0]["trials"]
    return [PENALTY if time is None or time > DURATION else time for time in times]


def tuned(program, scenario, budget, seed, out):
    ranges = {name: f"{low}..{high}" for name, (_, low, high) in PARAMETERS.items()}
    answer = run([program, "tune", str(scenario), *with_constants(ranges), "--budget", str(budget), "--seed", str(seed),
                  "--out", str(out), "--format", "json"])
    result = json.loads(answer.stdout)
    return {name: value for name, value in result["elites"][0]["constants"].items()}


# irace requests one instance after the other. Each candidate runs on BLOCK instances at once, so that its controller is
# built and its model parsed only once. irace counts and sees single trials.
BLOCK = 5
RACE = """
library(irace)
arguments <- commandArgs(TRUE)
parameters <- readParameters(text = '%s')
known <- new.env()
cost <- function(experiment, scenario) {
  values <- experiment$configuration
  words <- character()
  for (name in names(values)) words <- c(words, paste0(name, "=", format(values[[name]], scientific = FALSE)))
  block <- (experiment$instance - 1) %%/%% %d
  key <- paste(c(words, block), collapse = " ")
  if (is.null(known[[key]]))
    known[[key]] <- as.numeric(system2("python3", c("%s", "--block", block, "--program", "%s", "--bands", "%s", words),
                                       stdout = TRUE))
  list(cost = known[[key]][(experiment$instance - 1) %%%% %d + 1])
}
found <- irace(list(targetRunner = cost, instances = 1:10000, sampleInstances = 0,
                    maxExperiments = as.integer(arguments[1]), seed = as.integer(arguments[2]), digits = 3,
                    logFile = ""), parameters)
write.csv(removeConfigurationsMetaData(found[1, ]), arguments[3], row.names = FALSE)
"""


def has_irace():
    return shutil.which("Rscript") is not None and run(["Rscript", "-e", "library(irace)"]).returncode == 0


def by_irace(program, bands, budget, seed, folder):
    """The best candidate of irace; its target runner is this script with --block."""
    space = "\n".join(f'{name} "" {kind} ({low}, {high})' for name, (kind, low, high) in PARAMETERS.items())
    text = RACE % (space, BLOCK, pathlib.Path(__file__).resolve(), program, bands, BLOCK)
    script = folder / "race.R"
    script.write_text(text)
    table = folder / f"irace-{seed}.csv"
    answer = run(["Rscript", str(script), str(budget), str(seed), str(table)])
    if not table.exists():
        sys.exit(f"irace did not end:\n{answer.stdout[-2000:]}\n{answer.stderr[-2000:]}")
    row = next(csv.DictReader(table.open()))
    return {name: f"{float(row[name]):.3f}" if PARAMETERS[name][0] == "r" else row[name] for name in PARAMETERS}


def signed_rank(differences):
    """Wilcoxon's test, two-sided and exact, for few differences."""
    sizes = sorted(abs(each) for each in differences if each != 0)
    rank = {size: (2 * sizes.index(size) + sizes.count(size) + 1) / 2 for size in sizes}
    ranks = [rank[size] for size in sizes]
    seen = sum(rank[abs(each)] for each in differences if each > 0)
    middle = sum(ranks) / 2
    sums = [0.0]
    for each in ranks:
        sums = [total + sign for total in sums for sign in (0, each)]
    return sum(abs(total - middle) >= abs(seen - middle) for total in sums) / len(sums)


def one_block(arguments):
    """For irace: the costs of a block of instances, one per line."""
    constants = dict(word.split("=", 1) for word in arguments.constants)
    # Seeds that neither the claims nor `tune` use.
    first = 900_000_000 + arguments.block * BLOCK
    print(*costs(arguments.program, pathlib.Path(arguments.bands), constants, first, BLOCK), sep="\n")


def show(name, constants, found):
    arrived = sum(cost < PENALTY for cost in found)
    mean = sum(found) / len(found)
    print(f"{name:<10} {' '.join(f'{n}={v}' for n, v in constants.items()):<50} {arrived}/{len(found)} arrive, cost {mean:.1f}",
          flush=True)
    return mean


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", default="build/release/app/robochart-verify")
    parser.add_argument("--budget", type=int, default=2000)
    parser.add_argument("--repetitions", type=int, default=1)
    parser.add_argument("--fresh", type=int, default=200, help="trials in which what was found is judged")
    parser.add_argument("--bands", help=argparse.SUPPRESS)
    parser.add_argument("--block", type=int, help=argparse.SUPPRESS)
    parser.add_argument("constants", nargs="*", help=argparse.SUPPRESS)
    arguments = parser.parse_args()
    if arguments.block is not None:
        return one_block(arguments)
    program = str(pathlib.Path(arguments.program).resolve())
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        subprocess.run([str(pathlib.Path(__file__).parent.parent / "benchmarks/tunable_taxis.sh"), str(folder / "taxis")], check=True)
        scenario = folder / "taxis/tuning.scenario"
        bands = with_bands(scenario)
        judge = lambda label, constants: show(label, constants, costs(program, bands, constants, 600_001, arguments.fresh))
        judge("paper", PAPER)
        irace = has_irace()
        if not irace:
            print("irace is not installed (Debian: r-cran-irace): not compared")
        differences = []
        for seed in range(1, arguments.repetitions + 1):
            ours = judge("tune", tuned(program, scenario, arguments.budget, seed, folder / f"out-{seed}"))
            if irace:
                differences.append(ours - judge("irace", by_irace(program, bands, arguments.budget, seed, folder)))
                print(f"tune less irace, mean cost: {sum(differences) / len(differences):.1f}; "
                      f"signed-rank test of {len(differences)}: {signed_rank(differences):.3f}", flush=True)


if __name__ == "__main__":
    main()
