#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Decides the models of the Quantitative Verification Benchmark Set (shared/suite/prism/qvbs) with `robochart-verify
prism`. Compares values and numbers of states with those of the set, and CPU seconds with those of four checkers in
QComp 2020 for the same questions.

Usage: benchmarks/decide_qvbs.py --program PROGRAM --folder FOLDER [--jobs N] [--only TEXT] [--exact STATES]   (benchmarks/run.py qvbs)
"""
import argparse
import csv
import json
import math
import sys
from concurrent.futures import ThreadPoolExecutor
from fractions import Fraction

import measured

# The tables of QComp 2020: seconds with a guaranteed relative error of 1e-6, including startup (Storm, Storm static
# sparse, PRISM, mcsta).
QCOMP = {("mdp/consensus/consensus.4.prism", "K=4", "disagree"): (2.5, 2.5, 23, 5.9),
         ("dtmc/herman/herman.15.prism", "", "steps"): (4.2, 22.7, 16.1, None),
         ("mdp/wlan/wlan.4.prism", "COL=0", "cost_min"): (4.8, 4.0, 59, 15)}
RELATIVE = 1e-6
csv.field_size_limit(sys.maxsize)


def table(path):
    with open(path, newline="") as text:
        return list(csv.DictReader(text, delimiter="\t"))


def constants_of(text):
    """The constants, without B, which belongs to properties that are skipped."""
    return ",".join(each for each in text.split(",") if each and not each.startswith("B="))


def decide(options, model, constants, rows, exact):
    command = [options.program, "prism", f"{options.folder}/{model}", "--format", "json", "--threads", "1"]
    if constants:
        command += ["--const", constants]
    if exact:
        command += ["--exact"]
    for row in rows:
        command += ["--property", row["expression"]]
    return measured.run(command)


def fraction(row, long_ones):
    text = row["exact"]
    if "EXACT" in text:
        text = long_ones[row["id"]]
    return None if text in ("", "∞") else Fraction(text)


def fault(row, answer, long_ones, exact):
    """The first difference from the row; "" if there is none."""
    value = row["value"]
    if row["kind"] == "bool":
        return "" if answer["answer"] == value else f"{answer['answer']} instead of {value}"
    if answer["answer"] != "number":
        return f"{answer['answer']}: {answer.get('reason', '')}"
    low, high = (float(str(answer[end]).replace("Infinity", "inf")) for end in ("low", "high"))
    if value in ("Infinity", "∞"):
        return "" if math.isinf(low) else "finite"
    wanted = fraction(row, long_ones)
    if exact and wanted is not None:
        return "" if Fraction(answer.get("exact", "-1")) == wanted else f"exactly {answer.get('exact')}"
    if wanted is not None and not Fraction(low) <= wanted <= Fraction(high):
        return f"{float(wanted)} is outside [{low}, {high}]"
    number = float(wanted) if wanted is not None else float(value)
    least = 1e-15 * abs(number) if row["kind"] == "exact" else RELATIVE * abs(number)
    if not low - least <= number <= high + least:
        return f"{number} is outside [{low}, {high}]"
    return "" if high - low <= RELATIVE * max(abs(number), 1e-300) else f"wide: [{low}, {high}]"


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--program", required=True)
    parser.add_argument("--folder", required=True)
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--only", default="", help="models whose path has this in it")
    parser.add_argument("--exact", type=int, default=0, help="also with fractions, up to so many states")
    options = parser.parse_args()
    long_ones = {row["id"]: row["exact"] for row in table(options.folder + "/EXACT.tsv")}
    cases = {}
    refused = 0
    for row in table(options.folder + "/EXPECTED.tsv"):
        if options.only not in row["model"]:
            continue
        if row["dialect"] == "prism":
            cases.setdefault((row["model"], row["constants"]), []).append(row)
            continue
        ran = decide(options, row["model"], constants_of(row["constants"]), [row], False)
        refused += ran.exit == 2
        print(f"{row['id']}: exit {ran.exit}, {ran.said().strip().splitlines()[0][:100]}")
    with ThreadPoolExecutor(options.jobs) as jobs:
        runs = list(jobs.map(lambda case: decide(options, case[0][0], constants_of(case[0][1]), case[1], False),
                             cases.items()))
    wrong = right = exactly = 0
    print(f"{'model':<44} {'constants':<28} {'states':>9} {'answers':>7} {'CPU s':>8} {'MB':>6}   QComp 2020: Storm, its sparse engine, PRISM, mcsta")
    for ((model, constants), rows), ran in zip(cases.items(), runs):
        answers, states = [], 0
        if ran.exit in (0, 1):
            run = json.loads(ran.output)["runs"][0]
            answers, states = run["answers"], run["states"]
        faults = [fault(row, answer, long_ones, False) for row, answer in zip(rows, answers)]
        faults += [ran.said().strip()[-200:]] * (len(rows) - len(answers))
        if rows[0]["states_full"] and states != int(rows[0]["states_full"]):
            faults.append(f"{states} states instead of {rows[0]['states_full']}")
        recorded = [f"{row['property']} {figures}" for row in rows if (figures := QCOMP.get((model, constants, row["property"])))]
        print(f"{model:<44} {constants:<28} {states:>9,} {len(answers):>7} {ran.cpu:>8.2f} {ran.rss / 1e6:>6.0f}   {' '.join(recorded)}")
        bad = [each for each in faults if each]
        wrong += len(bad)
        right += len(rows) - len(bad)
        for each in bad:
            print("  " + each)
        if options.exact and 0 < states <= options.exact:
            ran = decide(options, model, constants_of(constants), rows, True)
            answers = json.loads(ran.output)["runs"][0]["answers"] if ran.exit in (0, 1) else []
            bad = [each for row, answer in zip(rows, answers) if (each := fault(row, answer, long_ones, True))]
            bad += [ran.said().strip()[-200:]] * (len(rows) - len(answers))
            wrong += len(bad)
            exactly += len(rows) - len(bad)
            print(f"  with fractions: {ran.cpu:.2f} CPU s" + "".join("\n  " + each for each in bad))
    print(f"{right} answers as the set has them, {wrong} not; {exactly} equal as fractions; {refused} refused by name; "
          f"{sum(ran.cpu for ran in runs):.1f} CPU s")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
