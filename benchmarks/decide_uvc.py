#!/usr/bin/env python3
"""The six sets of constants of the UVC case study, nineteen values each, by `robochart-verify prism`: compares the values with the reference,
and prints seconds beside those that PRISM 4.6 took (shared/suite/prism/uvc/EXPECTED.tsv).

Usage: benchmarks/decide_uvc.py --program PROGRAM --folder FOLDER [--jobs N]   (scripts/bench_uvc.sh)
"""
import argparse
import csv
import resource
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor

PROPERTY = ("const int t; P=? [ F shuman=SHuman_inRed & srobot=SRobot_transitionRow & "
            "modUVC_ctrlUVC_stm_ref3_ticks=t ]")
MOST_RELATIVE_DIFFERENCE = 1e-10


def decide(options, name, rows):
    """One set: seconds, and the table that the program prints."""
    constants = [each for each in rows[0]["constants"].split(",") if not each.startswith("t=")]
    times = [int(row["t"]) for row in rows]
    command = [options.program, "prism", options.folder + "/prism-gen/system.prism", "--property", PROPERTY,
               "--const", ",".join(constants + [f"t={min(times)}:{max(times)}"]), "--epsilon", "1e-11"]
    begin = time.monotonic()
    ran = subprocess.run(command + ["--format", "csv", "-q"], capture_output=True, text=True)
    seconds = time.monotonic() - begin
    if ran.returncode != 0:
        raise SystemExit(f"{name}: exit {ran.returncode}: {ran.stderr}")
    return seconds, list(csv.DictReader(ran.stdout.splitlines()))


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--program", required=True)
    parser.add_argument("--folder", required=True)
    parser.add_argument("--jobs", type=int, default=2)
    options = parser.parse_args()
    sets = {}
    with open(options.folder + "/EXPECTED.tsv", newline="") as table:
        for row in csv.DictReader(table, delimiter="\t"):
            if row["t"].isdigit():
                sets.setdefault(row["constant_set"], []).append(row)
    begin = time.monotonic()
    with ThreadPoolExecutor(options.jobs) as jobs:
        answers = list(jobs.map(lambda item: decide(options, *item), sets.items()))
    wall = time.monotonic() - begin
    worst = 0.0
    print(f"{'constants':<24} {'states':>10} {'seconds':>8} {'PRISM 4.6, seconds':>19}")
    for (name, rows), (seconds, found) in zip(sets.items(), answers):
        values = {int(row["t"]): float(row["value"]) for row in found}
        for row in rows:
            reference = float(row["reference"])
            difference = abs(values[int(row["t"])] - reference)
            worst = max(worst, difference / abs(reference) if reference else difference)
        prism = sum(float(row["prism_build_s"]) + float(row["prism_check_s"]) for row in rows)
        print(f"{name:<24} {int(rows[0]['states']):>10,} {seconds:>8.1f} {prism:>19,.0f}")
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    print(f"all: {wall:.1f} s with {options.jobs} programs at a time, {used.ru_utime:.1f} CPU s, at most "
          f"{used.ru_maxrss // 1024} MB each; values differ from the reference by at most {worst:.1e}")
    return 0 if worst <= MOST_RELATIVE_DIFFERENCE else 1


if __name__ == "__main__":
    sys.exit(main())
