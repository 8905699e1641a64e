#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Compares our scripts with RoboTool's published ones for the same models: bytes, and the states of every component's
compressed process (O__, timed with tock visible).

Prints a line for each script and totals. Exits with 1 if a component is missing or has more states in our script, with 77
without the scripts."""

import argparse
import json
import re
import sys
import tempfile
from pathlib import Path

from decide_components import Unusable, argument, components, model_of, text_of
from measured import run

LIMIT = 1_000_000  # states
HEADER = re.compile(r"des \(\d+, ?(\d+), ?(\d+)\)")


def model_path(script: Path) -> Path:
    name = script.stem.removeprefix("file_")
    folder = script.parent.parent / "models"
    return next(path for path in (folder / f"{name}.rct", folder / f"{re.sub(r'^ex', 'example', name)}.rct") if path.exists())


def own(program: str, model: Path, time: str) -> tuple[int, dict[str, int]]:
    """Bytes of our files, and states of O__ by component; -1: more than the limit."""
    with tempfile.TemporaryDirectory() as out:
        written = run([program, "emit", "csp", str(model), "--out", out, "--quiet"])
        folder = Path(out, "csp-gen") if time == "untimed" else Path(out, "csp-gen", "timed")
        size = sum(path.stat().st_size for path in folder.glob("*.csp"))
    child = run([program, "check", str(model), f"--{time}", "--sizes", "--format", "json", "--progress", "never"])
    try:
        sizes = json.loads(child.output)["sizes"]
    except (ValueError, LookupError):
        raise Unusable(child.errors.strip() or written.errors.strip() or f"exit {child.exit}") from None
    return size, {each["component"]: each["compressed"]["states"] if each["compressed"]["whole"] else -1 for each in sizes}


def theirs(program: str, script: Path) -> dict[str, int]:
    text, model = text_of(script), model_of(script)
    result = {}
    for path, (_, *constants) in components(text):
        process = f"{path}::O__({', '.join(['0'] + [argument(name, text, model) for name in constants])})"
        child = run([program, "cspm", str(script), "--export", "aut", process, "--max-states", str(LIMIT), "--progress", "never"])
        header = HEADER.match(child.output)
        result[path] = int(header[2]) if header else -1
    return result


def script_bytes(script: Path) -> int:
    """The size of RoboTool's files for this model: those with its name, and its library (core, robochart, state)."""
    defs = script.parent / "defs"
    patterns = (f"{script.stem}.csp", f"{script.stem}_defs.csp", "core_*.csp", "robochart_defs.csp", "state_*.csp")
    return script.stat().st_size + sum(path.stat().st_size for pattern in patterns for path in defs.glob(pattern))


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", required=True, help="robochart-verify, in release form")
    parser.add_argument("--scripts", type=Path, required=True, help="folder with untimed/, timed/ and models/")
    options = parser.parse_args()
    program = str(Path(options.program).resolve())
    scripts = [path.resolve() for time in ("untimed", "timed") for path in sorted((options.scripts / time).glob("*.csp"))
               if path.name != "instantiations.csp"]
    if not scripts:
        print(f"{options.scripts} has no scripts: nothing is compared")
        return 77
    bad, bytes_own, bytes_theirs = 0, 0, 0
    print(f"{'script':44} {'bytes':>8} {'RoboTool':>9} {'ratio':>6}   components: states, RoboTool's states")
    for script in scripts:
        time = script.parent.name
        if not model_of(script).strip():
            print(f"{time}/{script.stem}: its model is empty")
            continue
        try:
            size, states = own(program, model_path(script), time)
            others = theirs(program, script)
        except (Unusable, StopIteration) as error:
            print(f"{time}/{script.stem}: NOT COMPARED, {error}")
            bad += 1
            continue
        other_size = script_bytes(script)
        bytes_own, bytes_theirs = bytes_own + size, bytes_theirs + other_size
        pairs = [f"{path} {states.get(path, '?')}, {other}" for path, other in others.items()]
        larger = [path for path, other in others.items() if path not in states or 0 <= other < states[path]]
        bad += len(larger)
        print(f"{time + '/' + script.stem:44} {size:>8,} {other_size:>9,} {size / other_size:>6.2f}   {'; '.join(pairs)}"
              + (f"   LARGER: {', '.join(larger)}" if larger else ""), flush=True)
    print(f"{'together':44} {bytes_own:>8,} {bytes_theirs:>9,} {bytes_own / max(1, bytes_theirs):>6.2f}")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
