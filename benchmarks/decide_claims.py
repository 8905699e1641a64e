#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The cost of claims: 30 claims about a robot, all together, and a claim of three seconds with a time unit of 20 ms.

Each line has the number of claims, the verdicts, CPU and wall-clock seconds, and memory. The model is the warehouse robot
of shared/suite/claims.

Usage: benchmarks/decide_claims.py --program PROGRAM --folder shared/suite/claims   (benchmarks/run.py claims)
"""
import argparse
import tempfile
from pathlib import Path

import measured

UNLESS = "unless clear or estop or batteryLow"

CLAIMS = [
    "after estop until reset, never goTo or reverse or dock",
    "after estop until clear, never goTo or reverse or dock",
    "estop leads to brake before any call but brake",
    "estop leads to brake within 0 s",
    "reverse at least 3 s after obstacle",
    "reverse at least 3.1 s after obstacle",
    "for 3 s after obstacle, never reverse",
    "for 2.9 s after obstacle, never reverse",
    "after each start or clear or arrived, at most 3 reverse",
    "after each start or clear or arrived, at most 2 reverse",
    "never goTo(w) with w >= 4",
    "never goTo(w) with w >= 3",
    f"obstacle leads to reverse or callHelp within 3 s {UNLESS}",
    f"obstacle leads to reverse or callHelp within 2.9 s {UNLESS}",
    f"obstacle leads to reverse within 3 s {UNLESS}",
    "after batteryLow until charged, obstacle leads to halt within 0 s",
    "possible callHelp",
    "obstacle leads to halt",
    "obstacle leads to reverse",
    "never goTo(v) with v != last goTo and v != (last goTo + 1) % 4",
    "dock only within 0 s after batteryLow or reset",
    "before obstacle, never halt or reverse",
    "callHelp only after obstacle",
    "brake only within 0 s after estop",
    "arrived leads to goTo within 0 s unless estop or batteryLow",
    "halt only after obstacle or batteryLow or charged",
    "at most 2 callHelp in any 1 s",
    "reverse at least 2 s after reverse",
    "possible goTo(3)",
    "clear leads to goTo within 0 s unless estop",
]
RESPONSE = f"obstacle leads to reverse or callHelp within 3 s {UNLESS}"


def measure(program: str, model: str, unit: str, claims: list[str], title: str) -> None:
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "robot.rct").write_text(model)
        lines = "".join(f"claim C{number} : {claim}\n" for number, claim in enumerate(claims))
        (Path(folder) / "robot.claims").write_text(f"import warehouse::*\nunit {unit}\n{lines}")
        child = measured.run([program, "check", folder, "--no-cache", "-q"])
    last = child.output.strip().splitlines()[-1] if child.output.strip() else child.errors.strip()
    print(f"{title:<32} {last:<45} {child.cpu:6.2f} s CPU {child.wall:6.2f} s {child.rss / 2**20:6.0f} MiB")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", required=True)
    parser.add_argument("--folder", required=True, type=Path)
    arguments = parser.parse_args()
    model = (arguments.folder / "warehouse" / "warehouse.rct").read_text()
    measure(arguments.program, model, "0.1 s", CLAIMS[:1], "1 claim, unit 0.1 s")
    measure(arguments.program, model, "0.1 s", CLAIMS, f"{len(CLAIMS)} claims, unit 0.1 s")
    states = [f"while in Operating::Patrolling::Held, {claim}" for claim in ("never goTo", "never dock")]
    measure(arguments.program, model, "0.1 s", states, "2 claims about states")
    finer = model.replace("patience : nat = 30", "patience : nat = 150").replace("backoff : nat = 20", "backoff : nat = 100")
    measure(arguments.program, finer, "20 ms", [RESPONSE], "3 s with a unit of 20 ms")


if __name__ == "__main__":
    main()
