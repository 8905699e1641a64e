#!/usr/bin/env python3
"""Generated code against hand-written switches: speed, size, compile cost. Called by scripts/bench_code.sh.

Usage: bench_code.py COMMAND ROUNDS COMPILER STRATEGY
"""
import json
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
MACHINES = ("m1", "m2", "m3", "m4")
BARS = {("m1", "rand"): 1.00, ("m1", "pat"): 1.00, ("m2", "rand"): 1.00, ("m2", "pat"): 1.00,
        ("m3", "rand"): 0.97, ("m3", "pat"): 0.80, ("m4", "rand"): 0.70, ("m4", "pat"): 0.70}


def emit(command, strategy, folder):
    for machine in MACHINES:
        subprocess.run([command, "emit", "cpp", HERE / "models" / f"{machine}.rct", "--strategy", strategy, "--out",
                        folder / machine, "--quiet"], check=True, stdout=subprocess.DEVNULL)


def compile_unit(compiler, machine, back_end, folder, level, check=False):
    """One translation unit; user seconds and peak megabytes of the compiler."""
    name = machine.upper()
    target = folder / f"{machine}_{back_end}_{level}{'_check' if check else ''}.o"
    words = [compiler, "-std=c++17", "-Wall", "-Wextra", "-Werror", f"-{level}", "-fno-exceptions", "-fno-rtti", "-c", HERE / "code" / "unit.cpp",
             "-o", target, f"-DMACHINE={machine}", f"-DNAME={name}", f"-DHEADER={name}_core.hpp",
             f"-DGENERATED={int(back_end == 'generated')}", f"-DTICKS={int(machine == 'm2')}",
             "-I", HERE / "code", "-I", folder / machine / "cpp" / name] + (["-DCHECK"] if check else [])
    process = subprocess.Popen([str(word) for word in words])
    _, status, usage = os.wait4(process.pid, 0)
    if status:
        sys.exit(f"{target.name} does not compile")
    return target, usage.ru_utime, usage.ru_maxrss / 1024


def link(compiler, objects, folder, check):
    target = folder / ("check" if check else "bench")
    words = [compiler, "-std=c++17", "-O2", HERE / "code" / "main.cpp", *objects, "-o", target]
    words += ["-DCHECK"] if check else ["-lbenchmark", "-pthread"]
    subprocess.run([str(word) for word in words], check=True)
    return target


def one_round(program):
    text = subprocess.run([program, "--benchmark_format=json", "--benchmark_min_time=0.2",
                           "--benchmark_enable_random_interleaving=true"], check=True, capture_output=True, text=True)
    return {row["name"]: 1e9 / row["items_per_second"] for row in json.loads(text.stdout)["benchmarks"]}


def bytes_of(target):
    text = subprocess.run(["size", "-A", target], check=True, capture_output=True, text=True).stdout
    rows = [line.split() for line in text.splitlines()]
    return sum(int(row[1]) for row in rows if len(row) == 3 and row[0].startswith((".text", ".rodata")))


def speeds(program, rounds):
    results = [one_round(program) for _ in range(rounds)]
    print(f"\nns a step, median of {rounds} rounds; ratio to the hand-written switch within a round")
    print(f"{'':10} {'switch':>8} {'ours':>8} {'ratio':>7} {'bar':>6}")
    for machine in MACHINES:
        for stream in ("rand", "pat"):
            hand = [result[f"{machine}/switch/{stream}"] for result in results]
            ours = [result[f"{machine}/generated/{stream}"] for result in results]
            ratio = statistics.median(a / b for a, b in zip(ours, hand))
            print(f"{machine + ' ' + stream:10} {statistics.median(hand):8.2f} {statistics.median(ours):8.2f} "
                  f"{ratio:7.2f} {BARS[machine, stream]:6.2f}{'' if ratio <= BARS[machine, stream] else '  above'}")


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
    command, rounds, compiler, strategy = sys.argv[1], int(sys.argv[2]), sys.argv[3], sys.argv[4]
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        emit(command, strategy, folder)
        programs = []
        for check in (True, False):
            objects = [compile_unit(compiler, machine, back_end, folder, "O2", check)[0]
                       for machine in MACHINES for back_end in ("switch", "generated")]
            programs.append(link(compiler, objects, folder, check))
        print("what 20,000 random events store:", flush=True)
        subprocess.run([programs[0]], check=True)
        sizes(compiler, folder)
        speeds(programs[1], rounds)


if __name__ == "__main__":
    main()
