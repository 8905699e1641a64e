#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The cost of claims: 30 claims about a robot, all together, and a claim of three seconds with a time unit of 20 ms;
`conform` with five claims about cycles, compared with `conform` without claims; with --hvc, ten claims about the
high-voltage controller, compared with its slowest assertion.

Each line has the number of claims, the verdicts, CPU and wall-clock seconds, and memory. The models are those of
shared/suite/claims.

Usage: benchmarks/decide_claims.py --program PROGRAM --folder shared/suite/claims   (benchmarks/run.py claims)
"""
import argparse
import shutil
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


CYCLES = [
    "in a cycle with estop, any call but brake only after brake",
    "in a cycle with estop, always in Emergency",
    "in a cycle with estop, at most 3 any call",
    "in a cycle with obstacle, never reverse",
    "raised estop leads to brake within 0 units",
]
HVC = [
    "at most 3 int_enablePWM in any 4 ms",
    "int_enablePWM only after ext_pow24VStatus",
    "int_dutyCyclePWM1 only after ext_pow24VStatus",
    "ext_errorAck leads to int_enablePWM within 40 ms unless ext_pow24VStatus or ext_setPoint",
    "before ext_pow24VStatus, never int_enablePWM",
    "ext_errorAck only after ext_setPoint",
    "possible int_enablePWM(on) with on",
    "ext_setPoint leads to ext_setPoint or ext_errorAck or int_enablePWM within 100 ms",
    "after each ext_setPoint, at most 3 int_enablePWM",
    "for 4 ms after ext_errorAck, never int_dutyCyclePWM1",
]


def named(claims: list[str], component: str = "") -> str:
    of = f" of {component}" if component else ""
    return "".join(f"claim C{number}{of} : {claim}\n" for number, claim in enumerate(claims))


def show(title: str, child: measured.Child) -> measured.Child:
    last = child.output.strip().splitlines()[-1] if child.output.strip() else child.errors.strip()
    print(f"{title:<32} {last:<45} {child.cpu:6.2f} s CPU {child.wall:6.2f} s {child.rss / 2**20:6.0f} MiB", flush=True)
    return child


def measure(program: str, model: str, unit: str, claims: list[str], title: str) -> None:
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "robot.rct").write_text(model)
        (Path(folder) / "robot.claims").write_text(f"import warehouse::*\nunit {unit}\n{named(claims)}")
        show(title, measured.run([program, "check", folder, "--no-cache", "-q"]))


def measure_conform(program: str, model: str) -> None:
    """The cost of five claims about cycles beside the comparison of the code with its model."""
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "robot.rct").write_text(model)
        command = [program, "conform", folder, "--component", "Robot", "--no-cache", "-q"]
        without = show("conform", measured.run(command))
        (Path(folder) / "robot.claims").write_text(f"import small::*\n{named(CYCLES, 'Robot')}")
        with_claims = show(f"conform, {len(CYCLES)} claims", measured.run(command))
    print(f"{'':<32} {with_claims.cpu / without.cpu:.2f} times the CPU time, {with_claims.wall / without.wall:.2f} times the time")


def measure_hvc(program: str, hvc: Path) -> None:
    """All claims together, and the assertion that takes longest."""
    with tempfile.TemporaryDirectory() as folder:
        shutil.copytree(hvc, folder, dirs_exist_ok=True, ignore=shutil.ignore_patterns("robotool-csp"))
        (Path(folder) / "hvc.claims").write_text(f"unit 2 ms\n{named(HVC, 'mod_sys')}")
        command = [program, "check", folder, "--no-cache", "-q"]
        claims = [word for number in range(len(HVC)) for word in ("--assertion", f"C{number}")]
        together = show(f"{len(HVC)} claims, hvc", measured.run(command + claims))
        slowest = show("P1, hvc", measured.run(command + ["--assertion", "P1"]))
    print(f"{'':<32} {together.cpu / slowest.cpu:.2f} times the CPU time of the slowest assertion")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", required=True)
    parser.add_argument("--folder", required=True, type=Path)
    parser.add_argument("--hvc", type=Path, help="the folder of the high-voltage controller")
    arguments = parser.parse_args()
    model = (arguments.folder / "warehouse" / "warehouse.rct").read_text()
    measure(arguments.program, model, "0.1 s", CLAIMS[:1], "1 claim, unit 0.1 s")
    measure(arguments.program, model, "0.1 s", CLAIMS, f"{len(CLAIMS)} claims, unit 0.1 s")
    states = [f"while in Operating::Patrolling::Held, {claim}" for claim in ("never goTo", "never dock")]
    measure(arguments.program, model, "0.1 s", states, "2 claims about states")
    finer = model.replace("patience : nat = 30", "patience : nat = 150").replace("backoff : nat = 20", "backoff : nat = 100")
    measure(arguments.program, finer, "20 ms", [RESPONSE], "3 s with a unit of 20 ms")
    measure_conform(arguments.program, (arguments.folder / "small" / "patrol.rct").read_text())
    if arguments.hvc:
        measure_hvc(arguments.program, arguments.hvc)


if __name__ == "__main__":
    main()
