#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Compares generated code with hand-written switches: speed, size, compile cost. Called by benchmarks/run.py code.

Usage: bench_code.py COMMAND LAYOUTS COMPILER STRATEGY
"""
import json
import os
import pathlib
import random
import statistics
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE / "code"))

import write_machines

MACHINES = ("m1", "m2", "m3", "m4")
BARS = {("m1", "rand"): 1.00, ("m1", "pat"): 1.00, ("m2", "rand"): 1.00, ("m2", "pat"): 1.00,
        ("m3", "rand"): 0.97, ("m3", "pat"): 0.80, ("m4", "rand"): 0.70, ("m4", "pat"): 0.70}


def emit(command, strategy, folder):
    write_machines.write_switches(folder)
    for machine in MACHINES:
        subprocess.run([command, "emit", "cpp", HERE / "models" / f"{machine}.rct", "--strategy", strategy, "--out",
                        folder / machine, "--quiet"], check=True, stdout=subprocess.DEVNULL)


def compile_unit(compiler, machine, back_end, folder, level, purpose="size"):
    """Compiles one translation unit; returns user seconds and peak megabytes of the compiler."""
    name = machine.upper()
    target = folder / f"{machine}_{back_end}_{level}_{purpose}.o"
    words = [compiler, "-std=c++17", "-Wall", "-Wextra", "-Werror", f"-{level}", "-fno-exceptions", "-fno-rtti", "-c",
             HERE / "code" / "unit.cpp", "-o", target, f"-DMACHINE={machine}", f"-DNAME={name}",
             f"-DHEADER={name}_core.hpp", f"-DBACK_END={back_end}", f"-DGENERATED={int(back_end == 'generated')}",
             f"-DTICKS={int(machine == 'm2')}", "-I", HERE / "code", "-I", folder, "-I", folder / machine / "cpp" / name]
    more = {"size": [], "check": ["-DLOOP", "-DCHECK"], "time": ["-DLOOP", "-falign-functions=64"]}
    process = subprocess.Popen([str(word) for word in words + more[purpose]])
    _, status, usage = os.wait4(process.pid, 0)
    if status:
        sys.exit(f"{target.name} does not compile")
    return target, usage.ru_utime, usage.ru_maxrss / 1024


def link(compiler, objects, target):
    subprocess.run([str(word) for word in [compiler, *objects, "-o", target]], check=True)
    return target


def driver(compiler, folder, check):
    """The objects other than the back ends."""
    objects = []
    for source in [HERE / "code" / "main.cpp"] + ([] if check else [HERE / "cpu_time.cpp"]):
        objects.append(folder / f"{source.stem}{'_check' if check else ''}.o")
        words = [compiler, "-std=c++20", "-O2", "-c", source, "-o", objects[-1], "-I", HERE.parent]
        subprocess.run([str(word) for word in words + (["-DCHECK"] if check else [])], check=True)
    return objects


def bytes_of(target):
    text = subprocess.run(["size", "-A", target], check=True, capture_output=True, text=True).stdout
    rows = [line.split() for line in text.splitlines()]
    return sum(int(row[1]) for row in rows if len(row) == 3 and row[0].startswith((".text", ".rodata")))


def gap(folder, index, chance):
    """An object with up to 64 KB of code that is never executed."""
    target = folder / f"gap_{index}.o"
    text = f".text\n.skip {64 + 64 * chance.randrange(1024)}\n.section .note.GNU-stack\n"
    subprocess.run(["as", "-o", str(target)], input=text, text=True, check=True)
    return target


def one_layout(compiler, objects, back_ends, folder, chance):
    """Times by machine and stream, of a program with the back ends in another order and at other addresses, so that the
    layout of the code does not affect the result."""
    order = list(back_ends)
    chance.shuffle(order)
    apart = [part for i, one in enumerate(order) for part in (gap(folder, i, chance), one)]
    program = link(compiler, objects + apart, folder / "bench")
    text = subprocess.run([program], check=True, capture_output=True, text=True).stdout
    rows = [line.split() for line in text.splitlines()]
    return {(row[0], row[1]): tuple(map(float, row[2:])) for row in rows}


def speeds(compiler, objects, back_ends, folder, layouts):
    chance = random.Random(1)
    results = [one_layout(compiler, objects, back_ends, folder, chance) for _ in range(layouts)]
    print(f"\nns a step, means of {layouts} layouts of the program; ratio to the hand-written switch; noise: the same ratio "
          f"of the switch compiled twice")
    print(f"{'':10} {'switch':>8} {'ours':>8} {'ratio':>7} {'noise':>7} {'bar':>6}")
    for machine in MACHINES:
        for stream in ("rand", "pat"):
            hand, again, ours = map(statistics.fmean, zip(*(result[machine, stream] for result in results)))
            bar = BARS[machine, stream]
            print(f"{machine + ' ' + stream:10} {hand:8.2f} {ours:8.2f} {ours / hand:7.2f} {again / hand:7.2f} {bar:6.2f}"
                  f"{'' if round(ours / hand, 2) <= bar else '  above'}")


def sizes(compiler, folder):
    print("\nbytes of .text and .rodata; seconds and megabytes of the compiler at -O2")
    print(f"{'':6} {'switch -O2':>11} {'ours -O2':>11} {'switch -Os':>11} {'ours -Os':>11} {'seconds':>8} {'MB':>6}")
    for machine in MACHINES:
        row, cost = [], (0, 0)
        for level in ("O2", "Os"):
            for back_end in ("switch", "generated"):
                target, seconds, megabytes = compile_unit(compiler, machine, back_end, folder, level)
                row.append(bytes_of(target))
                cost = (seconds, megabytes) if (level, back_end) == ("O2", "generated") else cost
        print(f"{machine:6} {row[0]:11} {row[1]:11} {row[2]:11} {row[3]:11} {cost[0]:8.2f} {cost[1]:6.0f}")


def main():
    command, layouts, compiler, strategy = sys.argv[1], int(sys.argv[2]), sys.argv[3], sys.argv[4]
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        emit(command, strategy, folder)
        units = {purpose: [compile_unit(compiler, machine, back_end, folder, "O2", purpose)[0]
                           for machine in MACHINES for back_end in ("switch", "again", "generated")]
                 for purpose in ("check", "time")}
        print("what 20,000 random events store:", flush=True)
        subprocess.run([link(compiler, driver(compiler, folder, True) + units["check"], folder / "check")], check=True)
        sizes(compiler, folder)
        speeds(compiler, driver(compiler, folder, False), units["time"], folder, layouts)


if __name__ == "__main__":
    main()
