#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Measures what certificates cost, compared with a search without reductions on one thread.

For each assertion: decides it (--no-reduction, one thread, no cache), decides it again and writes its certificate, and has
robochart-certify check the certificate. Prints processor seconds, peak memory, and the ratios. With --hvc FOLDER also P4
of the high-voltage controller, in the script that we generate. Exits with 1 if a certificate is refused or a ratio is
larger than its limit: 4 in time, 2 in memory (of processes with at least 20 MB), 1.3 for writing."""

import argparse
import re
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path

from measured import run

MOST_TIME, MOST_MEMORY, MOST_WRITING, SMALL_MEMORY = 4.0, 2.0, 1.3, 20 << 20

BUFFERS = """
N = 12
channel link : {0..N}.Bool
Buffer(i) = link.i?bit -> link.(i + 1)!bit -> Buffer(i)
System = (|| i : {0..N-1} @ [{|link.i, link.(i + 1)|}] Buffer(i)) \\ {|link.i | i <- {1..N-1}|}
Queue(s) = (#s < N & link.0?b -> Queue(s^<b>)) [] (#s > 0 & link.N!head(s) -> Queue(tail(s)))
"""
PHILOSOPHERS = (Path(__file__).parent / "models/philosophers.csp").read_text().split("assert ")[0]
ANY = "Any = |~| x : {|think, sit, eat, rise, take, return|} @ x -> Any\n"

CASES = {
    "queue of 12 [FD= 12 buffers": BUFFERS + "assert Queue(<>) [FD= System\n",
    "queue of 12 [T= 12 buffers": BUFFERS + "assert Queue(<>) [T= System\n",
    "12 buffers, deadlock free": BUFFERS + "assert System :[deadlock free [F]]\n",
    "any event [FD= 7 philosophers": PHILOSOPHERS + ANY + "assert Any [FD= System\n",
    "7 philosophers, deadlock free": PHILOSOPHERS + "assert System :[deadlock free [F]]\n",
}


@dataclass
class Case:
    name: str
    script: Path
    assertion: int = 1


def owned_p4(program: str, folder: Path, out: Path) -> Case:
    run([program, "emit", "csp", str(folder), "--out", str(out), "--quiet"])
    scripts = list(out.glob("csp-gen/timed/*_assertions.csp"))
    if len(scripts) != 1:
        sys.exit(f"no script was written for {folder}")
    return Case("P4 of the high-voltage controller", scripts[0], 17)


def measure(options: argparse.Namespace, case: Case, certificates: Path) -> bool:
    command = [options.program, "cspm", str(case.script), "--assertion", str(case.assertion), "--no-reduction", "--threads",
               "1", "--no-cache", "--progress", "never"]
    plain = run(command)
    states = re.search(r"holds .*? ([\d,]+) states", plain.output, re.DOTALL)
    # The certifier is not on this path, so that writing is measured alone.
    written = run(["env", "PATH=/usr/bin:/bin", *command, "--certify", str(certificates)])
    checked = run([options.certifier, str(certificates)])
    pairs = re.search(r"([\d,]+) pairs?\b", checked.output)
    if plain.exit != 0 or written.exit != 0 or checked.exit != 0 or not states or not pairs:
        print(f"{case.name}: not certified\n{plain.said()}{written.said()}{checked.said()}")
        return False
    time = checked.cpu / plain.cpu
    memory = checked.rss / plain.rss
    writing = written.cpu / plain.cpu
    size = sum(file.stat().st_size for file in certificates.rglob("*") if file.is_file())
    print(f"| {case.name} | {states[1]} | {pairs[1]} | {plain.cpu:.2f} | {plain.rss >> 20} | {checked.cpu:.2f} | "
          f"{checked.rss >> 20} | {time:.1f} | {memory:.1f} | {writing:.2f} | {size:,} |", flush=True)
    return time <= MOST_TIME and (memory <= MOST_MEMORY or checked.rss < SMALL_MEMORY) and writing <= MOST_WRITING


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", required=True)
    parser.add_argument("--certifier", required=True)
    parser.add_argument("--hvc", type=Path)
    options = parser.parse_args()
    print("| claim | states | pairs | search, CPU s | MB | certifier, CPU s | MB | time | memory | writing | bytes |")
    print("| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |")
    good = True
    with tempfile.TemporaryDirectory() as folder:
        work = Path(folder)
        cases = []
        for number, (name, text) in enumerate(CASES.items()):
            script = work / f"case{number}.csp"
            script.write_text(text)
            cases.append(Case(name, script))
        if options.hvc:
            cases.append(owned_p4(options.program, options.hvc, work / "hvc"))
        for number, case in enumerate(cases):
            good = measure(options, case, work / f"certificates{number}") and good
    sys.exit(0 if good else 1)


main()
