#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Mutates real inputs and runs the whole command on them: every verb, under small limits, with hostile names, signals and
outputs that cannot be written.

The properties of every run: it exits with a documented exit code (0 to 4), within its limits of time and memory. No
sanitizer reports an error. A run that does not succeed prints a message. Its JSON and XML is well-formed, and no output
contains control characters or bytes that are not UTF-8. It writes no files outside its output folder, and only finished
files inside. No child process outlives it.
The folder of each run that violates a property is kept, with the command that reproduces the violation.
"""
import argparse
import collections
import concurrent.futures
import dataclasses
import json
import os
import pathlib
import random
import re
import resource
import shlex
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import xml.etree.ElementTree

import inputs
import seeds as kept_seeds

DOCUMENTED_EXITS = {0, 1, 2, 3, 4}


@dataclasses.dataclass
class Limits:
    """The limits passed to a run, and the larger limits that it must stay within, because the machine may be busy."""
    timeout: int
    memory: int  # MiB
    most_cpu: float
    most_wall: float
    most_resident: int

    def arguments(self, verb):
        return ["--timeout", str(self.timeout * (4 if compiles(verb) else 1)), "--memory", f"{self.memory}M"]


def compiles(verb):
    """Whether the verb runs compilers, whose time counts as its own."""
    return verb.startswith(("conform", "verify", "simulate", "tune"))


USUAL = Limits(2, 400, 3.5, 20, 520)
# Code with sanitizers is slower, and the sanitizers use most of its memory.
SANITIZED = Limits(6, 1500, 14, 90, 1900)
SANITIZERS = {"ASAN_OPTIONS": "detect_leaks=0:quarantine_size_mb=16:allocator_may_return_null=0",
              "UBSAN_OPTIONS": "halt_on_error=1:print_stacktrace=1"}
COMPLAINTS = re.compile(rb"ERROR: \w+Sanitizer|runtime error: ")


def cpu_seconds(process):
    """CPU seconds of the running program and of the children that it has waited for; 0 if it has ended."""
    try:
        with open(f"/proc/{process.pid}/stat", encoding="ascii", errors="replace") as stat:
            return sum(int(ticks) for ticks in stat.read().rpartition(")")[2].split()[11:15]) / os.sysconf("SC_CLK_TCK")
    except OSError:
        return 0


def resident_mib(process):
    try:
        with open(f"/proc/{process.pid}/status", encoding="ascii", errors="replace") as status:
            for line in status:
                if line.startswith("VmHWM:"):
                    return int(line.split()[1]) // 1024
    except OSError:
        pass
    return 0


@dataclasses.dataclass
class Run:
    """The observations of one run."""
    verb: str
    input: inputs.Input
    folder: pathlib.Path
    interrupted: bool  # a signal was sent to it
    full: bool  # its standard output cannot be written
    code: int = 0
    seconds: float = 0
    cpu: float = 0
    resident: int = 0
    left_running: bool = False  # a child outlived it
    fresh: frozenset = frozenset()  # files and folders that the run has created

    def out(self):
        return b"" if self.full else (self.folder / "stdout").read_bytes()

    def err(self):
        return (self.folder / "stderr").read_bytes()


def run_once(bench, verb, made, folder, rng):
    where = rng.random()
    interrupt_after = rng.random() * 0.8 if where < 0.05 else None
    run = Run(verb, made, folder, interrupt_after is not None, 0.05 <= where < 0.08)
    (folder / "tmp").mkdir()
    (folder / "typed").write_bytes(made.typed)
    before = set(folder.rglob("*"))
    environment = {**os.environ, **SANITIZERS, "TMPDIR": str(folder / "tmp"), "XDG_CACHE_HOME": str(bench.cache)}
    with open(folder / "typed", "rb") as typed, open("/dev/full" if run.full else folder / "stdout", "wb") as out, \
            open(folder / "stderr", "wb") as err:
        began = time.monotonic()
        process = subprocess.Popen([bench.command, *made.arguments], cwd=folder, stdin=typed, stdout=out, stderr=err, env=environment,
                                   start_new_session=True, preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CORE, (0, 0)))
        while process.poll() is None:
            run.resident = max(run.resident, resident_mib(process))
            run.cpu = max(run.cpu, cpu_seconds(process))
            elapsed = time.monotonic() - began
            if interrupt_after is not None and elapsed > interrupt_after:
                process.send_signal(rng.choice([signal.SIGINT, signal.SIGTERM]))
                interrupt_after = None
            if elapsed > bench.limits.most_wall:
                os.killpg(process.pid, signal.SIGKILL)
            time.sleep(0.01 if elapsed < 1 else 0.05)
    run.code = process.returncode
    run.seconds = time.monotonic() - began
    try:
        os.killpg(process.pid, signal.SIGKILL)
        run.left_running = True
    except ProcessLookupError:
        pass
    run.fresh = frozenset(set(folder.rglob("*")) - before - {folder / "stdout", folder / "stderr"})
    return run


def broken_promise(run, limits):
    """A violated property in words; None if there is none."""
    return broken_ending(run) or broken_limit(run, limits) or broken_output(run) or broken_files(run)


def broken_ending(run):
    if COMPLAINTS.search(run.err()):
        return "a sanitizer complains"
    if run.code < 0 and not (run.interrupted and -run.code in (signal.SIGINT, signal.SIGTERM)):
        return f"ended by signal {-run.code} after {run.seconds:.1f} s"
    if run.code >= 0 and run.code not in DOCUMENTED_EXITS:
        return f"exit code {run.code}"
    if b"internal error" in run.err():
        return "an internal error"
    if run.code > 0 and not run.full and not run.err() and not run.out():
        return f"exit code {run.code} and not a word"
    if run.full and run.code == 0 and not run.verb.startswith(("format", "emit", "lsp")) and "--types" not in run.input.arguments:
        return "exit code 0 with a standard output that cannot be written"
    if run.left_running:
        return "a child was left running"
    return None


def broken_limit(run, limits):
    if not compiles(run.verb) and run.verb != "lsp" and run.cpu > limits.most_cpu:
        return f"{run.cpu:.1f} CPU seconds with --timeout {limits.timeout}"
    if run.resident > limits.most_resident:
        return f"{run.resident} MiB with --memory {limits.memory}M"
    return None


# Control characters of terminals, and invisible characters. JSON may contain the latter.
UNSEEN = re.compile("[\x00-\x08\x0b\x0c\x0e-\x1f\x7f-\x9f\u200e\u200f\u202a-\u202e\u2066-\u2069]")
# These verbs print texts of the user unchanged.
VERBATIM = ("format", "lsp", "validate --fix")
BINARY = (".png", ".pdf")


def unescaped(text):
    try:
        found = UNSEEN.search(text.decode())
    except UnicodeDecodeError as error:
        return f"bytes that are no UTF-8 ({error})"
    return f"the character {found.group()!r}" if found else None


# The model calls an operation whose precondition is false: generated code differs because of an error in the model.
FAULTS_OF_MODELS = "RC-K11"


def differing(report):
    """The results in a JSON report for components whose code differs."""
    if isinstance(report, list):
        return [found for each in report for found in differing(each)]
    if not isinstance(report, dict):
        return []
    own = [report] if report.get("outcome") == "differs" else []
    return own + [found for each in report.values() for found in differing(each)]


def code_is_wrong(run):
    """Whether generated code differs from the model, and the report does not name an error of the model as the cause."""
    if run.input.json_wanted:
        try:
            return any(each.get("code") != FAULTS_OF_MODELS for each in differing(json.loads(run.out())))
        except ValueError:
            return b'"differs"' in run.out()
    results = run.out().split(b"DIFFERS")[1:]
    return not all(f"[{FAULTS_OF_MODELS}]".encode() in each for each in results)


def broken_output(run):
    if run.input.json_wanted and not run.full and run.code in (0, 1, 2, 3):
        try:
            json.loads(run.out())
        except ValueError as error:
            return f"exit code {run.code} and JSON that is none: {error}"
    if run.verb in ("conform", "verify") and code_is_wrong(run):
        return "model and generated code differ"
    if run.verb.startswith(VERBATIM):
        return None
    texts = [("error", run.err())] if run.input.json_wanted else [("output", run.out()), ("error", run.err())]
    for stream, text in texts:
        if what := unescaped(text):
            return f"standard {stream} has {what}"
    return None


READ_BACK = {".json": json.loads, ".sarif": json.loads, ".svg": xml.etree.ElementTree.fromstring, ".junit": xml.etree.ElementTree.fromstring}


def broken_files(run):
    out = run.folder / "out"
    strays = [path for path in run.fresh if out not in path.parents and path != out]
    if strays:
        return f"files outside of --out: {sorted(map(str, strays))[:3]}"
    for path in sorted(run.fresh):
        if ".part" in path.name or ".tmp" in path.name:
            return "an unfinished file was left behind"
        if not path.is_file() or path.suffix in BINARY:
            continue
        text = path.read_bytes()
        if path.suffix not in (".json", ".sarif") and (what := unescaped(text)):
            return f"{path.relative_to(run.folder)} has {what}"
        try:
            READ_BACK.get(path.suffix, len)(text)
        except (ValueError, xml.etree.ElementTree.ParseError) as error:
            return f"{path.relative_to(run.folder)} is not well-formed: {error}"
    return None


@dataclasses.dataclass
class Bench:
    """The parts that all runs share."""
    command: str
    reader: kept_seeds.Reader
    seeds: kept_seeds.Seeds
    verbs: dict  # name -> weight
    accepted: float
    limits: Limits
    kept: pathlib.Path
    cache: pathlib.Path


@dataclasses.dataclass
class Outcome:
    verb: str
    code: int
    accepted: bool
    broken: str


def one(bench, seed):
    rng = random.Random(seed)
    with tempfile.TemporaryDirectory(prefix="robochart-hostile-") as name:
        folder = pathlib.Path(name)
        verb = rng.choices(list(bench.verbs), list(bench.verbs.values()))[0]
        shop = inputs.Workshop(rng, bench.seeds, bench.reader, folder, bench.accepted, bench.limits.arguments(verb))
        made = inputs.VERBS[verb][1](shop)
        run = run_once(bench, verb, made, folder, rng)
        broken = broken_promise(run, bench.limits)
        if broken:
            keep(bench, run, seed, broken)
            broken = f"seed {seed}: {broken}: {shlex.join(made.arguments)}"
        return Outcome(verb, run.code, made.accepted, broken)


def keep(bench, run, seed, broken):
    place = bench.kept / str(seed)
    shutil.rmtree(place, ignore_errors=True)
    shutil.copytree(run.folder, place, symlinks=True)
    (place / "COMMAND").write_text(shlex.join(run.input.arguments) + "\n" + broken + "\n")


def chosen_verbs(text):
    """Verbs with their weights from a text such as `rules MODEL=3,conform=1`; all verbs if the text is empty."""
    if not text:
        return {verb: weight for verb, (weight, _) in inputs.VERBS.items()}
    chosen = {}
    for part in text.split(","):
        name, _, weight = part.partition("=")
        if name not in inputs.VERBS:
            sys.exit(f"--verbs: there is no '{name}'; there are: {', '.join(inputs.VERBS)}")
        chosen[name] = float(weight or 1)
    return chosen


def summary(outcomes):
    """A line for each verb: its numbers of inputs and of accepted inputs, and the exit codes of its runs."""
    by_verb = collections.defaultdict(list)
    for outcome in outcomes:
        by_verb[outcome.verb].append(outcome)
    for verb, those in sorted(by_verb.items()):
        codes = collections.Counter(outcome.code for outcome in those)
        yield (f"{verb:20} {len(those):6} inputs, {sum(outcome.accepted for outcome in those):6} accepted; exit codes " +
               ", ".join(f"{code}: {count}" for code, count in sorted(codes.items())))


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("command", help="the program")
    parser.add_argument("roots", nargs="+", help="folders with inputs to mutate")
    parser.add_argument("--inputs", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=0, help="of the first input; input N has seed SEED + N")
    parser.add_argument("--seconds", type=float, default=float("inf"), help="no input is begun after so many seconds")
    parser.add_argument("--verbs", default="", help="these alone, NAME=WEIGHT with commas between them: " + ", ".join(inputs.VERBS))
    parser.add_argument("--accepted", type=float, default=0.8, help="share of inputs that are mutated until the front end accepts them")
    parser.add_argument("--sanitized", action="store_true", help="the program has sanitizers: limits are larger")
    parser.add_argument("--pages", type=pathlib.Path, default=pathlib.Path("docs/rules"))
    parser.add_argument("--kept", type=pathlib.Path, default=pathlib.Path("build/hostile"))
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    options = parser.parse_args()
    options.kept.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(prefix="robochart-hostile-") as name:
        return attack(options, pathlib.Path(name))


def attack(options, scratch):
    command = str(scratch / "program")  # later builds do not affect this run
    shutil.copy2(options.command, command)
    kept_seeds.unpack_pages(options.pages, scratch / "pages")
    reader = kept_seeds.Reader(command)
    seeds = kept_seeds.Seeds([*options.roots, scratch / "pages"], reader)
    print(f"seed {options.seed}; files that are mutated: {seeds.summary()}", flush=True)
    verbs = chosen_verbs(options.verbs)
    if not seeds.paths["log"]:  # the repository has none
        verbs.pop("conform --traces", None)
    bench = Bench(command, reader, seeds, verbs, options.accepted, SANITIZED if options.sanitized else USUAL,
                  options.kept.resolve(), scratch / "cache")
    ends = time.monotonic() + options.seconds
    outcomes, broken = [], 0
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        numbers = range(options.seed, options.seed + options.inputs)
        for outcome in pool.map(lambda seed: one(bench, seed) if time.monotonic() < ends else None, numbers):
            if outcome is None:
                continue
            outcomes.append(outcome)
            if outcome.broken:
                broken += 1
                print(outcome.broken, flush=True)
            if len(outcomes) % 1000 == 0:
                print(f"{len(outcomes)} inputs, {broken} broken promises", flush=True)
    print("\n".join(summary(outcomes)))
    print(f"{len(outcomes) - broken} of {len(outcomes)} runs kept every promise")
    return 1 if broken else 0


if __name__ == "__main__":
    sys.exit(main())
