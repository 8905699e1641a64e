#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Measures the cost of the reduction of confluent taus for models where it may not pay off: locks, monitors and
schedulers of several sizes.

Writes the scripts and decides their assertions with and without --no-reduction, with one thread and no cache. Prints the
CPU time, the states and the ratio for each, then the maximal and the median ratio. The CPU time is the minimum of several
runs, because most runs take a few milliseconds, and other programs only make them longer. Exits with 1 if a verdict
differs."""

import argparse
import json
import statistics
import sys
import tempfile
from pathlib import Path

from measured import run

# Each family: its text with N for the size, and the sizes.
FAMILIES = {
    "test_and_set": ((4, 6, 8), """
T = {1..N}
channel try : T.Bool
channel free, enter, leave : T
Word(held) = try?t!(not held) -> Word(true) [] free?t -> Word(false)
Thread(t) = try.t?won -> (if won then enter.t -> leave.t -> free.t -> Thread(t) else Thread(t))
System = ((||| t : T @ Thread(t)) [| {|try, free|} |] Word(false)) \\ {|try, free|}
Spec = enter?t -> leave.t -> Spec
assert Spec [T= System
assert System :[deadlock free]
"""),
    "ticket": ((3, 4, 5), """
T = {1..N}
K = {0..N-1}
channel draw, served : T.K
channel next, enter, leave : T
Dispenser(k) = draw?t!k -> Dispenser((k + 1) % N)
Display(k) = served?t!k -> Display(k) [] next?t -> Display((k + 1) % N)
Thread(t) = draw.t?k -> served.t.k -> enter.t -> leave.t -> next.t -> Thread(t)
System = ((||| t : T @ Thread(t)) [| {|draw, served, next|} |] (Dispenser(0) ||| Display(0))) \\ {|draw, served, next|}
Spec = enter?t -> leave.t -> Spec
assert Spec [T= System
assert System :[deadlock free]
"""),
    "filter": ((3, 4), """
T = {1..N}
L = {1..N-1}
channel setLevel, getLevel : T.T.{0..N-1}
channel setLast, getLast : T.L.{0..N}
channel enter, leave : T
Level(i, v) = setLevel?t!i?w -> Level(i, w) [] getLevel?t!i!v -> Level(i, v)
Last(l, v) = setLast?t!l?w -> Last(l, w) [] getLast?t!l!v -> Last(l, v)
Climb(t, l) = if l == N then enter.t -> leave.t -> setLevel.t.t.0 -> Climb(t, 1)
              else setLevel.t.t.l -> setLast.t.l.t -> Wait(t, l, 1)
Wait(t, l, i) = if i > N then Climb(t, l + 1) else if i == t then Wait(t, l, i + 1)
                else getLevel.t.i?v -> (if v < l then Wait(t, l, i + 1) else getLast.t.l?w -> (if w == t then Wait(t, l, 1) else Climb(t, l + 1)))
Shared = {|setLevel, getLevel, setLast, getLast|}
System = ((||| t : T @ Climb(t, 1)) [| Shared |] ((||| i : T @ Level(i, 0)) ||| (||| l : L @ Last(l, 0)))) \\ Shared
Spec = enter?t -> leave.t -> Spec
assert Spec [T= System
assert System :[deadlock free]
"""),
    "semaphore": ((5, 7, 8), """
T = {1..N}
channel wait, signal, enter, leave : T
Semaphore(k) = k > 0 & wait?t -> Semaphore(k - 1) [] k < 2 & signal?t -> Semaphore(k + 1)
Thread(t) = wait.t -> enter.t -> leave.t -> signal.t -> Thread(t)
System = ((||| t : T @ Thread(t)) [| {|wait, signal|} |] Semaphore(2)) \\ {|wait, signal|}
Spec(k) = k < 2 & enter?t -> Spec(k + 1) [] k > 0 & leave?t -> Spec(k - 1)
assert Spec(0) [T= System
assert System :[deadlock free]
"""),
    "readers_writer": ((5, 6, 8), """
R = {1..N}
channel beginRead, endRead, read : R
channel beginWrite, endWrite, write
Lock(readers, writing) =
  (not writing and readers < N) & beginRead?r -> Lock(readers + 1, writing) [] readers > 0 & endRead?r -> Lock(readers - 1, writing)
  [] (readers == 0 and not writing) & beginWrite -> Lock(readers, true) [] writing & endWrite -> Lock(readers, false)
Reader(r) = beginRead.r -> read.r -> endRead.r -> Reader(r)
Writer = beginWrite -> write -> endWrite -> Writer
Locking = {|beginRead, endRead, beginWrite, endWrite|}
System = (((||| r : R @ Reader(r)) ||| Writer) [| Locking |] Lock(0, false)) \\ Locking
assert System :[deadlock free]
assert System :[divergence free]
"""),
    "round_robin": ((6, 8, 10), """
T = {0..N-1}
channel start, finish, turn : T
Cell(t) = turn.t -> start.t -> Running(t)
Running(t) = finish.t -> turn.((t + 1) % N) -> Cell(t) [] turn.((t + 1) % N) -> finish.t -> Cell(t)
First = start.0 -> Running(0)
Cells(t) = if t == 0 then First else Cell(t)
System = (|| t : T @ [{|start.t, finish.t, turn.t, turn.((t + 1) % N)|}] Cells(t)) \\ {|turn|}
assert System :[deadlock free]
assert System :[divergence free]
"""),
    "priorities": ((4, 5, 6), """
T = {1..N}
channel ready, run, yield, done : T
Scheduler(waiting) =
  ready?t:diff(T, waiting) -> Scheduler(union(waiting, {t}))
  [] (waiting != {}) & run!highest(waiting) -> Busy(diff(waiting, {highest(waiting)}))
Busy(waiting) = ready?t:diff(T, waiting) -> Busy(union(waiting, {t})) [] yield?t -> Scheduler(waiting)
highest(s) = pick({t | t <- s, {u | u <- s, u > t} == {}})
pick({t}) = t
Task(t) = ready.t -> run.t -> done.t -> yield.t -> Task(t)
System = ((||| t : T @ Task(t)) [| {|ready, run, yield|} |] Scheduler({})) \\ {|ready, run, yield|}
Spec = done?t -> Spec
assert Spec [T= System
assert System :[deadlock free]
assert System :[divergence free]
"""),
    "monitor": ((3, 4), """
T = {1..N}
channel lock, unlock, sleep, wake, put, get : T
channel count : T.{0..2}
channel set : T.{0..2}
Mutex = lock?t -> Held(t)
Held(t) = unlock.t -> Mutex [] sleep.t -> Mutex
Sleepers(s) = sleep?t:diff(T, s) -> Sleepers(union(s, {t})) [] wake?t -> Waking(s) [] ([] t : s @ awake.t -> Sleepers(diff(s, {t})))
channel awake : T
Waking(s) = if s == {} then Sleepers(s) else ([] t : s @ awake.t -> Sleepers(diff(s, {t})))
Count(k) = count?t!k -> Count(k) [] set?t?j -> Count(j)
Producer(t) = lock.t -> Full(t)
Full(t) = count.t?k -> (if k == 2 then sleep.t -> awake.t -> lock.t -> Full(t)
                        else put.t -> set.t.(k + 1) -> wake.t -> unlock.t -> Producer(t))
Consumer(t) = lock.t -> Empty(t)
Empty(t) = count.t?k -> (if k == 0 then sleep.t -> awake.t -> lock.t -> Empty(t)
                         else get.t -> set.t.(k - 1) -> wake.t -> unlock.t -> Consumer(t))
Inside = {|lock, unlock, sleep, wake, awake, count, set|}
System = ((||| t : T @ if t % 2 == 0 then Producer(t) else Consumer(t)) [| Inside |] ((Mutex [| {|sleep|} |] Sleepers({})) ||| Count(0))) \\ Inside
assert System :[deadlock free]
assert System :[divergence free]
"""),
    "token_ring": ((4, 5, 6), """
T = {0..N-1}
channel pass, want, enter, leave : T
Node(t) = want.t -> Wanting(t) [] pass.t -> pass.((t + 1) % N) -> Node(t)
Wanting(t) = pass.t -> enter.t -> leave.t -> pass.((t + 1) % N) -> Node(t)
Holder(t) = pass.((t + 1) % N) -> Node(t)
Nodes(t) = if t == 0 then Holder(t) else Node(t)
System = (|| t : T @ [{|want.t, enter.t, leave.t, pass.t, pass.((t + 1) % N)|}] Nodes(t)) \\ {|pass|}
Spec = enter?t -> leave.t -> Spec
assert Spec [T= System \\ {|want|}
assert System :[deadlock free]
assert System :[divergence free]
"""),
    "barrier": ((5, 7, 8), """
T = {1..N}
channel arrive, go, work : T
Barrier(k) = if k == N then Release(N) else arrive?t -> Barrier(k + 1)
Release(k) = if k == 0 then Barrier(0) else go?t -> Release(k - 1)
Thread(t) = work.t -> arrive.t -> go.t -> Thread(t)
System = ((||| t : T @ Thread(t)) [| {|arrive, go|} |] Barrier(0)) \\ {|arrive, go|}
assert System :[deadlock free]
assert System :[divergence free]
"""),
    "rendezvous": ((3, 4), """
T = {1..N}
channel acquire, release, park : T
channel unpark, meet : T.T
channel look, leaveName : T.{0..N}
Lock = acquire?t -> release.t -> Lock
Slot(x) = look?t!x -> Slot(x) [] leaveName?t?y -> Slot(y)
Thread(t) = acquire.t -> look.t?x -> (if x == 0 then leaveName.t.t -> release.t -> unpark?u:diff(T, {t})!t -> meet.u.t -> Thread(t)
                                      else leaveName.t.0 -> release.t -> unpark.t.x -> Thread(t))
Inside = {|acquire, release, look, leaveName|}
Pairs(t) = {|acquire.t, release.t, look.t, leaveName.t, meet.u.t, unpark.t.u, unpark.u.t | u <- T|}
System = (((|| t : T @ [Pairs(t)] Thread(t)) [| Inside |] (Lock ||| Slot(0))) \\ Inside) \\ {|unpark|}
assert System :[deadlock free]
assert System :[divergence free]
"""),
}


def decide(program: str, script: Path, options: list[str]) -> tuple[float, list[tuple[str, int]]]:
    command = [program, "cspm", str(script), "--threads", "1", "--no-cache", "--format", "json", "--progress", "never"]
    child = run(command + options)
    answer = json.loads(child.output)
    if not answer["results"]:
        raise SystemExit(f"{script.name}: {answer['errors']}")
    return child.cpu, [(result["answer"], result["visited_states"]) for result in answer["results"]]


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", default="build/release/app/robochart-verify")
    parser.add_argument("--repeat", type=int, default=7, help="how often each is run; the fastest run counts (7)")
    parser.add_argument("--only", default="", help="only families whose name contains this")
    arguments = parser.parse_args()

    ratios = []
    differs = False
    with tempfile.TemporaryDirectory() as folder:
        for family, (sizes, text) in FAMILIES.items():
            if arguments.only not in family:
                continue
            for size in sizes:
                lines = text.split("assert ")
                for number, assertion in enumerate(lines[1:], 1):
                    script = Path(folder, f"{family}{size}_{number}.csp")
                    script.write_text(f"N = {size}\n{lines[0]}assert {assertion}")
                    runs = [(decide(arguments.program, script, []), decide(arguments.program, script, ["--no-reduction"]))
                            for _ in range(arguments.repeat)]
                    reduced, whole = runs[0][0][1], runs[0][1][1]
                    cpu = min(run[0][0] for run in runs)
                    cpu_whole = min(run[1][0] for run in runs)
                    differs |= [verdict for verdict, _ in reduced] != [verdict for verdict, _ in whole]
                    ratio = cpu / cpu_whole
                    ratios.append((ratio, cpu - cpu_whole, script.stem))
                    print(f"{script.stem:20} {reduced[0][0]:10} {1000 * cpu:8.1f} ms {reduced[0][1]:8} states   "
                          f"{1000 * cpu_whole:8.1f} ms {whole[0][1]:8} states   {ratio:5.2f}", flush=True)
    largest = max(ratios)
    print(f"{len(ratios)} assertions: median {statistics.median(ratio for ratio, _, _ in ratios):.2f}, "
          f"largest {largest[0]:.2f} ({largest[2]}, {1000 * largest[1]:+.1f} ms), "
          f"{sum(ratio > 1.5 for ratio, _, _ in ratios)} above 1.5")
    return 1 if differs else 0


if __name__ == "__main__":
    sys.exit(main())
