#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Decides the six sets of constants of the UVC case study with nineteen values each, and its deadlock check, with
`robochart-verify prism`. Compares states, transitions and values with the reference, and prints seconds next to those of
PRISM 4.6 (shared/suite/prism/uvc/EXPECTED.tsv).

Usage: benchmarks/decide_uvc.py --program PROGRAM --folder FOLDER [--jobs N] [--usual] [--model]   (benchmarks/run.py uvc)
--usual: the default width of intervals, compared with PRISM's own results.
--model: the model in RoboChart with its assertions, with `check --encoding robotool`, and not RoboTool's PRISM file.
"""
import argparse
import csv
import json
import resource
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor

PROPERTY = ("const int t; P=? [ F shuman=SHuman_inRed & srobot=SRobot_transitionRow & "
            "modUVC_ctrlUVC_stm_ref3_ticks=t ]")
NO_DEADLOCK = '! E [ F "deadlock" ]'


def decide(options, name, rows):
    """Decides one set; returns seconds and the output of the program."""
    constants = [each for each in rows[0]["constants"].split(",") if not each.startswith("t=")]
    times = [int(row["t"]) for row in rows]
    command = [options.program, "prism", options.folder + "/prism-gen/system.prism", "--property", PROPERTY,
               "--const", ",".join(constants + [f"t={min(times)}:{max(times)}"]), "--threads", "1"]
    if not options.usual:
        command += ["--epsilon", "1e-11"]
    begin = time.monotonic()
    ran = subprocess.run(command + ["--format", "json", "-q"], capture_output=True, text=True)
    seconds = time.monotonic() - begin
    if ran.returncode != 0:
        raise SystemExit(f"{name}: exit {ran.returncode}: {ran.stderr}")
    return seconds, json.loads(ran.stdout)["runs"][0]


def decide_model(options, name):
    """Decides one set with the assertions of the model."""
    command = [options.program, "check", options.folder, "--encoding", "robotool", "--format", "json", "-q",
               "--prefs", options.folder + "/prism-gen/rc2prism.prefs", "--assertion", "P_dangerous_" + name]
    if not options.usual:
        command += ["--epsilon", "1e-11"]
    begin = time.monotonic()
    ran = subprocess.run(command, capture_output=True, text=True)
    seconds = time.monotonic() - begin
    if ran.returncode != 0:
        raise SystemExit(f"{name}: exit {ran.returncode}: {ran.stderr}")
    rows = json.loads(ran.stdout)["assertions"][0]["probability"]["rows"]
    return seconds, {"states": rows[0]["states"], "transitions": rows[0]["transitions"],
                     "answers": [{"constants": {"t": row["constants"]["t"]}, "value": row["value"]} for row in rows]}


def deadlock_free(options, row):
    command = [options.program, "prism", options.folder + "/prism-gen/system.prism", "--property", NO_DEADLOCK,
               "--const", ",".join(each for each in row["constants"].split(",") if not each.startswith("t="))]
    return subprocess.run(command, capture_output=True).returncode == 0


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--program", required=True)
    parser.add_argument("--folder", required=True)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--usual", action="store_true")
    parser.add_argument("--model", action="store_true")
    parser.add_argument("--only", default="", help="sets of constants whose name has this in it")
    options = parser.parse_args()
    wanted, most = ("prism_result", 1e-5) if options.usual else ("reference", 1e-10)
    sets = {}
    deadlock = []
    with open(options.folder + "/EXPECTED.tsv", newline="") as table:
        for row in csv.DictReader(table, delimiter="\t"):
            if options.only not in row["constant_set"]:
                continue
            if row["t"].isdigit():
                sets.setdefault(row["constant_set"], []).append(row)
            else:
                deadlock.append(row)
    begin = time.monotonic()
    with ThreadPoolExecutor(options.jobs) as jobs:
        answers = list(jobs.map(
            lambda item: decide_model(options, item[0]) if options.model else decide(options, *item), sets.items()))
    wall = time.monotonic() - begin
    worst, right = 0.0, 0
    print(f"{'constants':<24} {'states':>10} {'seconds':>8} {'PRISM 4.6, seconds':>19}")
    for (name, rows), (seconds, found) in zip(sets.items(), answers):
        values = {int(answer["constants"]["t"]): answer["value"] for answer in found["answers"]}
        for row in rows:
            reference = float(row[wanted])
            difference = abs(values[int(row["t"])] - reference) / (abs(reference) or 1)
            worst = max(worst, difference)
            right += (difference <= most and found["states"] == int(row["states"])
                      and found["transitions"] == int(row["transitions"]))
        prism = sum(float(row["prism_build_s"]) + float(row["prism_check_s"]) for row in rows)
        print(f"{name:<24} {int(rows[0]['states']):>10,} {seconds:>8.1f} {prism:>19,.0f}")
    right += sum(deadlock_free(options, row) == (row["prism_result"] == "true") for row in deadlock)
    total = sum(map(len, sets.values())) + len(deadlock)
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    print(f"all: {wall:.1f} s with {options.jobs} programs at a time, {used.ru_utime:.1f} CPU s, at most "
          f"{used.ru_maxrss // 1024} MB each; {right} of {total} answers with equal states and transitions, values within "
          f"{most:.0e} of {wanted} (at most {worst:.1e})")
    return 0 if right == total else 1


if __name__ == "__main__":
    sys.exit(main())
