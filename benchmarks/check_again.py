#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks the high-voltage controller from scratch, then again after edits of its smaller machines, with cached results of
earlier runs (docs/cli.md, "Answers of earlier runs").

Prints the processor time of each run, and the speedup over the run from scratch. Exits with 1 if an answer differs from
that of a run without a cache, with 77 without the model."""

import argparse
import json
import os
import shutil
import sys
import tempfile
from pathlib import Path

from measured import Child, run

# The edits: description, file, old text, new text.
EDITS = [
    ("nothing", "", "", ""),
    ("a comment in front of all", "Transition_system.rct", "diagram Transition_system", "// edited\n\ndiagram Transition_system"),
    ("a guard, in other words", "Transition_system.rct", "condition fresh == false", "condition not fresh"),
    ("a guard that is then always true", "Transition_system.rct", "condition fresh == false",
     "condition fresh == false \\/ power == Power :: Off \\/ power == Power :: On"),
    ("a guard of the controller", "sequential_StateMachine.rct", "condition setPoint != 0 /\\ HVEnabled == false",
     "condition setPoint == 1 /\\ HVEnabled == false"),
]


def check(program: str, folder: Path, *options: str) -> tuple[list, Child]:
    """The answers, and the resources that they took."""
    child = run([program, "check", str(folder), "--format", "json", *options])
    try:
        assertions = json.loads(child.output)["assertions"]
    except (ValueError, LookupError):
        sys.exit(f"no report:\n{child.errors}")
    return assertions, child


def answers(assertions: list) -> list:
    return [(each["title"], each["answer"], each.get("counterexample", {}).get("steps")) for each in assertions]


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", required=True)
    parser.add_argument("--folder", type=Path, required=True, help="with the model")
    parser.add_argument("--compare", action="store_true", help="check each edit from scratch too")
    options = parser.parse_args()
    if not options.folder.exists():
        print(f"{options.folder} is not there: nothing to check")
        return 77
    wrong = False
    with tempfile.TemporaryDirectory() as temporary:
        os.environ["XDG_CACHE_HOME"] = temporary
        model = Path(temporary) / "hvc"
        model.mkdir()
        sources = [each for each in options.folder.iterdir() if each.suffix in (".rct", ".assertions")]
        _, first = check(options.program, options.folder)
        print("| edit | answers known | CPU s | times shorter | wall s |")
        print("| --- | --- | --- | --- | --- |")
        print(f"| (from scratch) | | {first.cpu:.1f} | | {first.wall:.1f} |", flush=True)
        for name, file, before, after in EDITS:
            for source in sources:
                shutil.copy(source, model)
            if file:
                text = (model / file).read_text()
                if before not in text:
                    sys.exit(f"{file} has no `{before}`")
                (model / file).write_text(text.replace(before, after, 1))
            again, child = check(options.program, model)
            known = sum(1 for each in again if each.get("known"))
            print(f"| {name} | {known} of {len(again)} | {child.cpu:.1f} | {first.cpu / child.cpu:.1f} | {child.wall:.1f} |",
                  flush=True)
            if options.compare:
                anew, _ = check(options.program, model, "--no-cache")
                if answers(anew) != answers(again):
                    wrong = True
                    print(f"the answers differ from those without a cache: {name}")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
