#!/usr/bin/env python3
"""Searches with checkpoints, and with states on disk, beside the ordinary search (docs/search.md, "Out of core").

Prints for each model how much processor time and memory each takes as a ratio of the ordinary search, and the bytes of
memory a state at the peak; exits with 1 if an answer or a number of states differs, with 77 without the models. Memory
is what a run takes above that of the same program with nothing to search."""

import argparse
import json
import sys
import tempfile
from pathlib import Path

from measured import Child, run


def decide(program: str, script: Path, number: int, *more: str) -> tuple[dict, Child]:
    child = run([program, "cspm", str(script), "--assertion", str(number), "-b", "--format", "json", "--no-cache",
                 "--no-reduction", *more])
    try:
        return json.loads(child.output)["results"][0], child
    except (ValueError, LookupError):
        sys.exit(f"{script}: no report:\n{child.errors}")


def nothing(program: str, temporary: str) -> int:
    script = Path(temporary) / "nothing.csp"
    script.write_text("channel a\nassert a -> STOP [T= STOP\n")
    return run([program, "cspm", str(script)]).rss


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", required=True)
    parser.add_argument("--part", type=float, default=4, help="of the memory of the ordinary search, one in so many")
    parser.add_argument("models", nargs="+", help="SCRIPT:NUMBER of an assertion")
    options = parser.parse_args()
    wrong = False
    print("| model | search | answer | states | CPU, ratio | memory, ratio | bytes a state |")
    print("| --- | --- | --- | --- | --- | --- | --- |")
    for model in options.models:
        name, number = model.rsplit(":", 1)
        script = Path(name)
        if not script.exists():
            print(f"{script} is not there")
            return 77
        with tempfile.TemporaryDirectory() as temporary:
            base = nothing(options.program, temporary)
            whole, first = decide(options.program, script, int(number), "--threads", "1")
            states = whole["visited_states"]
            memory = max(first.rss - base, 1)

            def row(what: str, result: dict, child: Child) -> None:
                nonlocal wrong
                used = max(child.rss - base, 0)
                print(f"| {script.stem} {number} | {what} | {result['answer']} | {result['visited_states']:,} | "
                      f"{child.cpu / first.cpu:.2f} | {used / memory:.2f} | {used / states:.1f} |", flush=True)
                same = result["answer"] == whole["answer"]
                wrong = wrong or not same or (result["answer"] == "holds" and result["visited_states"] != states)

            row("ordinary", whole, first)
            for minutes in ("1000", "0.1"):
                folder = str(Path(temporary) / "kept")
                row(f"checkpoints, --every {minutes}",
                    *decide(options.program, script, int(number), "--checkpoint", folder, "--every", minutes))
            limit = base + int(memory / options.part)
            row(f"on disk, 1/{options.part:g} of the memory",
                *decide(options.program, script, int(number), "--disk", str(Path(temporary) / "disk"), "--memory",
                        str(limit)))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
