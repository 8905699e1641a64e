#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Decides deadlock, divergence and determinism of every component (module, controller, machine, operation) of
RoboTool's own scripts, for each `X::O__(id, constants...)`; timed scripts are unchanged, with tock visible.

Each assertion is decided twice: with all states, and with confluent taus followed (docs/search.md), column `kept`. Times
are those with all states. Prints a line for each script, totals, and the reason if there is no verdict. Exits with 1 if a
script does not load, an assertion is not decided or the two answers differ, with 77 without the scripts."""

import argparse
import json
import re
import subprocess
import sys
import tempfile
import time
from collections import Counter
from dataclasses import dataclass, field
from pathlib import Path

from measured import Child, run

PROPERTIES = ["deadlock free [FD]", "divergence free", "deterministic [FD]"]
# The start and end of a module, and the definition of its optimised process, which RoboTool's assertions are about.
LANDMARK = re.compile(r"^[ \t]*(?:module[ \t]+(\w+)|(endmodule)\b|O__[ \t]*\(([^)]*)\)[ \t]*=)", re.MULTILINE)
COMMENT = re.compile(r"\{-.*?-\}|--[^\n]*", re.DOTALL)
INCLUDE = re.compile(r'^[ \t]*include[ \t]+"([^"]+)"', re.MULTILINE)
LIMIT = 600  # seconds per assertion; far above the minute that all scripts together should take


class Unusable(Exception):
    """A script whose components cannot be checked, and the reason."""


@dataclass
class Outcome:
    components: int = 0
    answers: Counter = field(default_factory=Counter)  # by property and verdict
    undecided: list[str] = field(default_factory=list)
    states: int = 0
    kept: int = 0  # states if confluent taus are followed
    wall: float = 0
    cpu: float = 0

    def decided(self) -> int:
        return sum(self.answers.values())

    def add(self, other: "Outcome") -> None:
        self.components += other.components
        self.answers += other.answers
        self.undecided += other.undecided
        self.states += other.states
        self.kept += other.kept
        self.wall += other.wall
        self.cpu += other.cpu


def text_of(script: Path) -> str:
    """The script with its included files in place, without comments."""
    try:
        text = COMMENT.sub("", script.read_text())
    except OSError as error:
        raise Unusable(f"{script.name}: {error.strerror}") from None
    return INCLUDE.sub(lambda found: text_of(script.parent / found[1]), text)


def components(text: str) -> list[tuple[str, list[str]]]:
    """Path and parameters of every O__, also in nested modules."""
    path: list[str] = []
    result = []
    for found in LANDMARK.finditer(text):
        if found[1]:
            path.append(found[1])
        elif found[2]:
            if not path:
                raise Unusable("an endmodule too many")
            path.pop()
        else:
            result.append(("::".join(path), [name.strip() for name in found[3].split(",")]))
    return result


def argument(name: str, text: str, model: str) -> str:
    """The instantiation of a constant; if it has a value in the model and none in the script, the value in the model."""
    if re.search(rf"^{name}[ \t]*=", text, re.MULTILINE):
        return name
    for found in re.finditer(r"\bconst\s+(\w+)\s*:\s*\w+\s*=\s*(-?\d+|true|false)\b", model):
        if name.endswith("_" + found[1]):
            return found[2]
    raise Unusable(f"neither script nor model gives {name} a value")


def model_of(script: Path) -> str:
    """The text of the model from which the script was generated (ex2 is the package of example2)."""
    name = script.stem.removeprefix("file_")
    for candidate in (name, re.sub(r"^ex(\d)", r"example\1", name)):
        path = script.parent.parent / "models" / (candidate + ".rct")
        if path.exists():
            return path.read_text()
    return ""


def questions(script: Path) -> tuple[int, list[str]]:
    """The number of components in the script, and the assertions about them."""
    text, model = text_of(script), model_of(script)
    if len(re.findall(r"^[ \t]*O__[ \t]*\(", text, re.MULTILINE)) != len(components(text)):
        raise Unusable("an O__ of it is not understood")
    asked = []
    for path, (_, *constants) in components(text):
        process = f"{path}::O__({', '.join(['0'] + [argument(name, text, model) for name in constants])})"
        asked += [f"{process} :[{wanted}]" for wanted in PROPERTIES]
    return len(asked) // len(PROPERTIES), asked


def answers(program: str, script: Path, asked: int, *more: str) -> tuple[list[dict], Child]:
    """The results for the given number of assertions of a script, and the resources that they took."""
    child = run([program, "cspm", str(script), "--format", "json", "--brief", "--progress", "never",
                 "--timeout", str(LIMIT), "--no-cache", *more])
    try:
        answer = json.loads(child.output)
        results = answer["results"]
    except (ValueError, LookupError):
        raise Unusable(f"exit {child.exit}: {child.errors.strip() or child.output.strip()}") from None
    if answer["errors"] or len(results) != asked:
        raise Unusable(f"{len(results)} of {asked} assertions answered: {'; '.join(answer['errors'])}")
    return results, child


def decide(program: str, script: Path, folder: str) -> Outcome:
    count, asked = questions(script)
    mine = Path(folder, f"{script.parent.name}_{script.stem}.csp")
    mine.write_text(f'include "{script}"\n' + "".join(f"assert {each}\n" for each in asked))
    results, child = answers(program, mine, len(asked), "--no-reduction")
    reduced, _ = answers(program, mine, len(asked))
    outcome = Outcome(count, wall=child.wall, cpu=child.cpu)
    for index, (each, result, less) in enumerate(zip(asked, results, reduced)):
        outcome.states += result.get("visited_states") or 0
        outcome.kept += less.get("visited_states") or 0
        if result["result"] != less["result"]:
            raise Unusable(f"{each}: {result['answer']}, but {less['answer']} with fewer states")
        if result["result"] in (0, 1):
            outcome.answers[PROPERTIES[index % len(PROPERTIES)], result["result"]] += 1
        else:
            outcome.undecided.append(f"{each}: {result.get('answer')} {'; '.join(result['errors'])}")
    return outcome


def type_check(program: str, script: Path) -> bool:
    """Loads and type checks a script; prints the result and the reason for a failure."""
    begin = time.monotonic()
    child = subprocess.run([program, "cspm", "--typecheck", str(script)], capture_output=True, text=True)
    if child.returncode == 0:
        print(f"{script.parent.name}/{script.stem}: loads and type checks, {time.monotonic() - begin:.2f} s")
    else:
        print(f"{script}: NOT LOADED, exit {child.returncode}: {child.stderr.strip() or child.stdout.strip()}")
    return child.returncode == 0


def row(name: str, outcome: Outcome) -> str:
    return (f"{name:52} {outcome.components:>10} {outcome.decided():>8} {len(outcome.undecided):>12} "
            f"{outcome.states:>10,} {outcome.kept:>10,} {outcome.wall:>8.2f} {outcome.cpu:>8.2f}")


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", required=True, help="robochart-verify, in release form")
    parser.add_argument("--scripts", type=Path, required=True, help="folder with untimed/, timed/ and models/")
    parser.add_argument("--typecheck", type=Path, action="append", default=[], metavar="SCRIPT",
                        help="another script, to load and type check only")
    parser.add_argument("--keep", type=Path, metavar="FOLDER", help="keep the scripts that were decided there")
    parser.add_argument("names", nargs="*", help="only scripts with one of these in their names (default: all)")
    options = parser.parse_args()
    found = [path.resolve() for kind in ("untimed", "timed") for path in sorted((options.scripts / kind).glob("*.csp"))]
    scripts = {f"{path.parent.name}/{path.stem}": path for path in found if path.name != "instantiations.csp"}
    if not scripts:
        print(f"{options.scripts} has no scripts: nothing is decided")
        return 77
    program = str(Path(options.program).resolve())
    chosen = [name for name in scripts if not options.names or any(part in name for part in options.names)]
    if not chosen:
        sys.exit(f"no script is named so: {' '.join(options.names)}")
    total, unusable = Outcome(), 0
    print(f"{'script':52} {'components':>10} {'decided':>8} {'inconclusive':>12} {'states':>10} {'kept':>10} {'wall s':>8} "
          f"{'CPU s':>8}")
    with tempfile.TemporaryDirectory() as made:
        folder = str(options.keep or made)
        Path(folder).mkdir(parents=True, exist_ok=True)
        for name in chosen:
            try:
                outcome = decide(program, scripts[name], folder)
            except Unusable as error:
                print(f"{name}: NOT LOADED, {error}")
                unusable += 1
                continue
            total.add(outcome)
            print(row(name, outcome), flush=True)
            for each in outcome.undecided:
                print(f"  UNDECIDED: {each}")
    print(row(f"{len(chosen) - unusable} of {len(chosen)} scripts", total))
    for wanted in PROPERTIES:
        print(f"  {wanted:20} holds {total.answers[wanted, 1]:>3}, fails {total.answers[wanted, 0]:>3}")
    unusable += sum(not type_check(program, script) for script in options.typecheck if script.exists())
    return 1 if unusable or total.undecided else 0


if __name__ == "__main__":
    sys.exit(main())
