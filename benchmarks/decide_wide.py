#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Decides questions about networks of many parts, which have more states than a search can store: schedulers,
philosophers, cells, buffers, robots (benchmarks/models), of several sizes.

Prints answer, states, CPU seconds, memory, and how the answer was found, for each. Sizes that a search of all states can
decide are also decided with --no-reduction. Exits with 1 if an answer is not the expected one."""

import argparse
import json
import re
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path
from typing import Optional

from measured import run

MODELS = Path(__file__).resolve().parent / "models"


@dataclass
class Question:
    model: str  # a script of benchmarks/models, whose first lines define N
    assertion: str
    sizes: tuple[int, ...]  # decided with the usual methods
    whole: tuple[int, ...]  # decided by a search of all states, too
    answer: str = "holds"
    more: str = ""  # definitions in addition to those of the script


SYMMETRIC = """
Right(i) = think.i -> sit.i -> take.i.i -> take.i.right(i) -> eat.i -> return.i.right(i) -> return.i.i -> rise.i -> Right(i)
Greedy = (|| i : Seats @ [Actions(i)] Right(i)) [| {|take, return|} |] (||| f : Seats @ Fork(f))
"""
ORDER = "Turns(i) = start.i -> Turns(next(i))\n"
# In these specifications, all parts have visible events, so few steps are confluent.
LOOSE_ORDER = ORDER + "Loose = Turns(0) ||| RUN({|finish|})\nLate = Turns(0) ||| CHAOS({|finish|})\n"
FIRST_CELL = """
First(k) = count.0.k -> First((k + 1) % 4)
Others = {|count.i | i <- {1..N-1}|}
"""
FILLING = "Fill(k) = (k < N & link.0?x -> Fill(k + 1)) [] (k > 0 & link.N?x -> Fill(k - 1))\n"
FIRST_ROBOT = "First = ROBOT(1, 1) [| {tock} |] CHAOS(diff({|tock, step|}, {|step.1|}))\n"

QUESTIONS = [
    Question("scheduler", "System :[deadlock free [F]]", (15, 40, 100, 500), (15,)),
    Question("scheduler", "System \\ {|turn|} :[divergence free]", (15, 40, 100, 500), (15,)),
    Question("scheduler", "System :[deterministic [FD]]", (15, 40, 100, 500), (15,)),
    Question("scheduler", "Turns(0) [FD= System \\ {|turn, finish|}", (15, 40, 100), (), "holds", ORDER),
    Question("scheduler", "Loose [T= System \\ {|turn|}", (15, 40, 100), (), "holds", LOOSE_ORDER),
    Question("scheduler", "Late [FD= System \\ {|turn|}", (15, 40), (), "fails", LOOSE_ORDER),
    Question("philosophers", "System :[deadlock free [F]]", (7, 8, 10, 12, 20, 100, 500), (7,)),
    Question("philosophers", "System :[deadlock free [FD]]", (7, 8, 10), (7,)),
    Question("philosophers", "System :[divergence free]", (7, 100, 500), (7,)),
    Question("philosophers", "System :[deterministic [FD]]", (7, 100, 500), (7,)),
    Question("philosophers", "Greedy :[deadlock free [F]]", (5, 7, 15), (5, 7), "fails", SYMMETRIC),
    Question("cells", "System :[deadlock free [F]]", (10, 50, 200), (10,)),
    Question("cells", "System :[deterministic [FD]]", (10, 50, 200), (10,)),
    Question("cells", "First(0) ||| RUN(Others) [T= System", (8, 50, 200), (8,), "holds", FIRST_CELL),
    Question("cells", "First(0) ||| CHAOS(Others) [FD= System", (8, 50, 200), (8,), "holds", FIRST_CELL),
    Question("buffers", "System :[deadlock free [F]]", (12, 50, 100), (12,)),
    Question("buffers", "System :[divergence free]", (12, 50, 100), (12,)),
    Question("buffers", "Fill(0) [T= System", (10, 50, 100), (10,), "holds", FILLING),
    Question("robots", "SWARM :[deadlock free]", (6, 20, 200), (6,)),
    Question("robots", "First [F= SWARM", (5, 20, 200), (5,), "holds", FIRST_ROBOT),
]


def script_of(question: Question, size: int) -> str:
    text = (MODELS / f"{question.model}.csp").read_text()
    text = re.sub(r"^assert .*\n", "", text, flags=re.MULTILINE)
    if question.model == "robots":
        text = text.replace("{1..20}", "{1..%d}" % size)
    else:
        text = re.sub(r"^N = \d+$", f"N = {size}", text, flags=re.MULTILINE)
    return f"{text}{question.more}assert {question.assertion}\n"


def decide(program: str, script: Path, seconds: int, *more: str) -> tuple[Optional[dict], float, int]:
    """The result, the processor time and the memory."""
    child = run([program, "cspm", str(script), "--format", "json", "--no-cache", "--threads", "1", "--timeout",
                 str(seconds), "--memory", "2GiB", *more])
    try:
        return json.loads(child.output)["results"][0], child.cpu, child.rss
    except (ValueError, LookupError):
        sys.exit(f"{script}: no report\n{child.errors}")


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", default="build/release/app/robochart-verify")
    parser.add_argument("--timeout", type=int, default=60, help="seconds for each question (60)")
    parser.add_argument("--only", default="", help="only models whose name contains this")
    arguments = parser.parse_args()
    print("| model, N | question | answer | decided by | states | CPU s | MB | all states | CPU s of all | ratio |")
    print("| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |")
    wrong = 0
    with tempfile.TemporaryDirectory() as folder:
        for question in QUESTIONS:
            if arguments.only not in question.model:
                continue
            for size in question.sizes:
                script = Path(folder, f"{question.model}{size}.csp")
                script.write_text(script_of(question, size))
                result, cpu, rss = decide(arguments.program, script, arguments.timeout)
                row = [f"{question.model} {size}", "`%s`" % question.assertion.replace("|", "\\|"), result["answer"], result["decided_by"],
                       f"{result['visited_states']:,}", f"{cpu:.2f}", f"{rss / 2**20:.0f}"]
                wrong += result["answer"] != question.answer
                if size in question.whole:
                    whole, whole_cpu, _ = decide(arguments.program, script, arguments.timeout, "--no-reduction")
                    wrong += whole["answer"] != question.answer
                    row += [f"{whole['visited_states']:,}", f"{whole_cpu:.2f}", f"{cpu / whole_cpu:.2f}"]
                else:
                    row += ["", "", ""]
                print(f"| {' | '.join(row)} |", flush=True)
    if wrong:
        print(f"{wrong} answers are not the expected ones")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
