#!/usr/bin/env python3
"""Mutates real inputs and runs the whole command on them: every verb, under small limits, with hostile names, signals and
outputs that cannot be written.

What is promised of every run: it ends by itself with a documented exit code (0 to 4), within its limits of time and memory;
what is no success says something; JSON that it prints is JSON; nothing is written outside its output folder, and nothing but
finished files inside; no child outlives it.
Each run that breaks a promise is kept in a folder of its own with the command that shows it.
"""
import argparse
import concurrent.futures
import dataclasses
import json
import os
import pathlib
import random
import re
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time

TIMEOUT_SECONDS = 2
MEMORY_MIB = 400
# The limits may be passed by a tenth or half a second; the rest is for a machine that does other things as well.
MOST_CPU_SECONDS = 3.5
MOST_WALL_SECONDS = 20
MOST_RESIDENT_MIB = 520
DOCUMENTED_EXITS = {0, 1, 2, 3, 4}

HOSTILE_NAMES = [
    "int", "class", "template", "union", "STOP", "SKIP", "card", "head", "tock", "Events", "assert", "BUFSIZ", "NULL", "errno",
    "EXIT_SUCCESS", "std", "step", "state", "value", "inputs", "Int", "_", "_x", "__x", "x__", "main", "within", "true", "D__",
    "O__", "core_nat", "printf", "stdin", "linux", "unix", "min", "max", "TIDS", "Timed", "WAIT", "module", "endmodule",
]
HOSTILE_LITERALS = [
    '"\\""', '"*/"', '"//\\"', '"??/"', '"%s%n"', '"{}"', '"${x}"', '"\\n"', '")\\""', '"</svg>"', '"\\\\"', "99999999999999999999",
    "-9223372036854775808", "9223372036854775807", "0.000000000000000000001", "1e999", "4294967296", "65536", "1/0",
]
HOSTILE_BYTES = [b"\x00", b"\xff\xfe", b"\xe2\x80\xae", b"\x1b[2J", b"\r", b"\xc0\xaf", b"\xef\xbb\xbf", b"\t" * 50]
HOSTILE_FILES = ["a b", "-x", "a'b", 'a"b', "a;b", "$(x)", "a\\b", "ä", "a%sb", "{}", "a\nb", "x" * 200]

OPERATOR = re.compile(rb"\[(?:T|F|FD)=|\[\]|\|~\||\|\|\||<=|>=|==|!=|=>|/\\|\\/|[-+*/%<>;?!.]")
WORD = re.compile(rb"[A-Za-z_][A-Za-z_0-9]*|[0-9]+(?:\.[0-9]+)?|\"[^\"\n]*\"|[^\sA-Za-z_0-9]")


def change_bytes(rng, text, words):
    at = rng.randrange(len(text) + 1)
    return text[:at] + rng.choice(HOSTILE_BYTES) + text[at + rng.randrange(3):]


def cut(rng, text, words):
    at = rng.randrange(len(text) + 1)
    return text[:at] if rng.random() < 0.3 else text[:at] + text[at + rng.randrange(1, 80):]


def repeat_lines(rng, text, words):
    lines = text.split(b"\n")
    first = rng.randrange(len(lines))
    block = lines[first:first + rng.randrange(1, 8)]
    where = rng.randrange(len(lines) + 1)
    return b"\n".join(lines[:where] + block * rng.choice([1, 1, 2, 30]) + lines[where:])


def remove_lines(rng, text, words):
    lines = text.split(b"\n")
    first = rng.randrange(len(lines))
    return b"\n".join(lines[:first] + lines[first + rng.randrange(1, 5):])


def replaced_word(rng, text, new, wanted=lambda word: True):
    found = [match for match in WORD.finditer(text) if wanted(match.group())]
    if not found:
        return text
    match = rng.choice(found)
    return text[:match.start()] + new(match.group()) + text[match.end():]


def other_word(rng, text, words):
    return replaced_word(rng, text, lambda _: rng.choice(words))


def swap_words(rng, text, words):
    mine = WORD.findall(text)
    return replaced_word(rng, text, lambda _: rng.choice(mine)) if mine else text


def alike_word(rng, text, words):
    """A word becomes another that stands behind the same word elsewhere in the text, so that it may stay well-formed."""
    found = list(WORD.finditer(text))
    behind = {}
    for before, match in zip(found, found[1:]):
        behind.setdefault(before.group(), set()).add(match.group())
    choices = [(match, behind[before.group()]) for before, match in zip(found, found[1:]) if len(behind[before.group()]) > 1]
    if not choices:
        return text
    match, others = rng.choice(choices)
    like = [word for word in sorted(others - {match.group()}) if word[:1].isalpha() == match.group()[:1].isalpha()]
    return text[:match.start()] + rng.choice(like or [match.group()]) + text[match.end():]


def other_number(rng, text, words):
    return replaced_word(rng, text, lambda _: rng.choice([b"0", b"1", b"2", b"3", b"7", b"100", b"-1", b"0.5"]), lambda word: word.isdigit())


def other_operator(rng, text, words):
    kinds = [[b"+", b"-", b"*", b"/", b"%"], [b"<", b">", b"<=", b">=", b"==", b"!="], [b"/\\", b"\\/", b"=>", b" and ", b" or "],
             [b"[]", b"|~|", b"|||", b";", b"[|{}|]", b"/\\", b"[>"], [b"?", b"!", b"."], [b"[T=", b"[F=", b"[FD="]]
    found = [(match, kind) for match in OPERATOR.finditer(text) for kind in kinds if match.group() in kind]
    if not found:
        return text
    match, kind = rng.choice(found)
    return text[:match.start()] + rng.choice(kind) + text[match.end():]


def hostile_name(rng, text, words):
    """One name becomes another in the whole text, so that it may stay well-formed."""
    names = sorted(set(re.findall(rb"\b[A-Za-z_][A-Za-z_0-9]*\b", text)))
    if not names:
        return text
    new = rng.choice(HOSTILE_NAMES).encode()
    return re.sub(rb"\b" + rng.choice(names) + rb"\b", lambda _: new, text)


def hostile_literal(rng, text, words):
    return replaced_word(rng, text, lambda _: rng.choice(HOSTILE_LITERALS).encode(),
                         lambda word: word[:1] in b"\"0123456789" or rng.random() < 0.05)


def nest(rng, text, words):
    opening, closing = rng.choice([(b"(", b")"), (b"{", b"}"), (b"<", b">"), (b"not ", b""), (b"-", b""), (b"let x = ", b" within x")])
    depth = rng.choice([3, 300, 30000])
    return replaced_word(rng, text, lambda word: opening * depth + word + closing * depth)


# These often leave the text well-formed.
CAREFUL = [alike_word, alike_word, alike_word, other_number, other_operator, hostile_name, hostile_literal]
ANY = [change_bytes, cut, repeat_lines, remove_lines, other_word, other_word, swap_words, swap_words, swap_words, hostile_name,
             hostile_name, hostile_literal, hostile_literal, nest]


@dataclasses.dataclass
class Seeds:
    """The inputs that are mutated, each a file and those beside it that it needs; and the words that they are made of."""
    models: list  # those that are right as they are
    scripts: list
    wrong_models: list
    wrong_scripts: list
    words: dict

    @staticmethod
    def below(roots, command, jobs):
        models, scripts, words = set(), set(), {"model": set(), "script": set()}
        for root in roots:
            for path in sorted(pathlib.Path(root).rglob("*")):
                if not path.is_file() or path.stat().st_size > LARGEST_SEED:
                    continue
                if path.suffix in (".rct", ".assertions"):
                    models.add(path)
                    words["model"].update(WORD.findall(path.read_bytes()))
                elif path.suffix == ".csp":
                    scripts.add(path)
                    words["script"].update(WORD.findall(path.read_bytes()))
        with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
            models = list(pool.map(lambda path: needed(command, path, (".rct", ".assertions"), ["validate"]), sorted(models)))
            scripts = list(pool.map(lambda path: needed(command, path, (".csp",), ["cspm", "--typecheck"]), sorted(scripts)))
        return Seeds([seed for seed, right in models if right], [seed for seed, right in scripts if right],
                     [seed for seed, right in models if not right], [seed for seed, right in scripts if not right],
                     {kind: sorted(found) for kind, found in words.items()})


LARGEST_SEED = 40_000


def needed(command, path, suffixes, verb):
    """The file alone where that is right, otherwise with what lies beside it; and whether that is right."""
    beside = [other for other in sorted(path.parent.iterdir())
              if other.suffix in suffixes and other != path and other.stat().st_size < LARGEST_SEED][:20]
    for others in ([], [other for other in beside if other.stem == path.stem], beside):
        with tempfile.TemporaryDirectory(prefix="robochart-hostile-") as folder:
            for each in [path, *others]:
                shutil.copyfile(each, pathlib.Path(folder) / each.name)
            if reads([command, *verb, path.name if ".csp" in suffixes else "."], folder):
                return (path, others), True
    return (path, beside), False


def mutate(rng, seed, path, words, reading, folder):
    """Writes a mutation of the seed; most are tried until `reading` finds nothing wrong, so that they come far."""
    original = seed.read_bytes()
    careful = rng.random() < 0.5
    attempts = 10 if rng.random() < 0.8 else 1
    for attempt in range(attempts):
        text = original
        for _ in range(rng.choice([1, 1, 1, 2, 3, 6] if attempt < 2 else [1, 2])):
            text = rng.choice(CAREFUL if careful or attempt > 1 else ANY)(rng, text, words)
        path.write_bytes(text)
        if text != original and (attempt + 1 == attempts or reads(reading, folder)):
            break


PROPERTIES = ["is deadlock-free", "is divergence-free", "is deterministic", "terminates", "is timelock-free", "is not deadlock-free"]
CLAIMS = ["assert {} :[deadlock free [F]]", "assert {} :[divergence free]", "assert {} :[deterministic [FD]]", "assert STOP [T= {}",
          "assert {0} [FD= {0}", "assert {} :[has trace]: <>", "print {}"]


def claim_models(rng, model):
    """Claims for models that have none."""
    if any(path.suffix == ".assertions" for path in model.iterdir()):
        return
    names = []
    for path in sorted(model.iterdir()):
        text = path.read_bytes().decode(errors="replace")
        package = re.match(r"\s*package\s+([\w:]+)", text)
        for name in re.findall(r"^\s*(?:stm|controller|module)\s+(\w+)", text, re.MULTILINE):
            names.append(f"{package[1]}::{name}" if package else name)
    claims = [f"assertion Claim{i} : {rng.choice(names)} {rng.choice(PROPERTIES)}\n" for i in range(3) if names]
    (model / "claims.assertions").write_text("".join(claims))


def claim_script(command, rng, path):
    text = path.read_bytes()
    if re.search(rb"^\s*(?:assert|print)\b", text, re.MULTILINE):
        return
    types = subprocess.run([command, "cspm", "--types", path.name, "--timeout", "2"], cwd=path.parent, stdin=subprocess.DEVNULL,
                           capture_output=True, check=False).stdout.decode(errors="replace")
    processes = re.findall(r"^(\w+)\s*::?\s*Proc$", types, re.MULTILINE)
    names = processes or re.findall(r"^(\w+)\s*::?", types, re.MULTILINE)
    if names:
        claims = [rng.choice(CLAIMS if processes else ["print {}"]).format(rng.choice(names)) + "\n" for _ in range(3)]
        path.write_bytes(text + b"\n" + "".join(claims).encode())


def reads(reading, folder):
    return subprocess.run([*reading, "--timeout", "2"], cwd=folder, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                          stderr=subprocess.DEVNULL, check=False).returncode == 0


VERBS = [["validate"]] * 3 + [["check", "--core"]] * 6 + [["check"]] * 5 + [["emit", "csp"]] * 3 + [["emit", "cpp"]] * 4 + [
    ["conform"], ["emit", "monitor"], ["emit", "monitor"], ["emit", "tests"], ["format"], ["format", "--check"], ["validate", "--fix"], []]
WRITING = [[], ["emit", "csp"], ["emit", "cpp"], ["emit", "monitor"], ["emit", "tests"]]


def lay_out(command, rng, seeds, folder):
    """Writes one mutated input into the folder; returns the arguments of the command and whether they ask for JSON."""
    limits = ["--timeout", str(TIMEOUT_SECONDS), "--memory", f"{MEMORY_MIB}M"]
    few_states = ["--max-states", str(rng.choice([1, 10, 1000]))] if rng.random() < 0.2 else []
    json_wanted = rng.random() < 0.4
    right = rng.random() < 0.9
    if rng.random() < 0.3:
        seed, beside = rng.choice(seeds.scripts if right else seeds.wrong_scripts)
        for each in beside:
            shutil.copyfile(each, folder / each.name)
        mutate(rng, seed, folder / seed.name, seeds.words["script"], [command, "cspm", "--typecheck", seed.name], folder)
        claim_script(command, rng, folder / seed.name)
        how = rng.choice([[], [], [], ["--typecheck"], ["--types"], ["-b"]])
        if json_wanted and not how:
            how = ["--format", rng.choice(["json", "framed_json"])]
            json_wanted = how[1] == "json"
        else:
            json_wanted = False
        return ["cspm", *limits, *few_states, *how, seed.name], json_wanted
    seed, beside = rng.choice(seeds.models if right else seeds.wrong_models)
    model = folder / "model"
    model.mkdir()
    for each in beside:
        shutil.copyfile(each, model / each.name)
    name = seed.name if rng.random() < 0.9 else rng.choice(HOSTILE_FILES) + seed.suffix
    mutate(rng, seed, model / name, seeds.words["model"], [command, "validate", "model"], folder)
    verb = rng.choice(VERBS)
    if verb == ["check"]:
        claim_models(rng, model)
    if verb[:1] == ["format"]:
        return [*verb, *(str(path.relative_to(folder)) for path in sorted(model.iterdir()))], False
    if verb[:1] != ["validate"]:
        limits += few_states
    if verb in WRITING:
        limits += ["--out", "out"]
        if verb == ["emit", "cpp"] and rng.random() < 0.5:
            limits += rng.choice([["--target", target] for target in ("library", "main", "ros2", "enki", "argos")] +
                                 [["--choices"], ["--strategy", "switch"], ["--strategy", "table"]])
    if verb[:1] == ["check"] and rng.random() < 0.4:
        limits += rng.choice([["--timed"], ["--untimed"], ["--sizes"], ["--trace"], ["--range", "nat=0..3"], ["--range", "clock=0..2"]])
    if verb[:1] in (["validate"], ["check"], ["conform"]) and json_wanted:
        return [*verb, *limits, "--format", "json", "model"], True
    return [*verb, *limits, "model"], False


def cpu_seconds(process):
    """Of the program and the children that it has waited for, as long as it runs."""
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
    """What was seen of one run."""
    arguments: list
    folder: pathlib.Path
    json_wanted: bool
    interrupted: bool  # a signal was sent to it
    full: bool  # its standard output cannot be written
    code: int = 0
    seconds: float = 0
    cpu: float = 0
    resident: int = 0
    left_running: bool = False  # a child outlived it
    fresh: frozenset = frozenset()  # files and folders that were not there before

    def out(self):
        return b"" if self.full else (self.folder / "stdout").read_bytes()

    def err(self):
        return (self.folder / "stderr").read_bytes()


def run_once(command, arguments, folder, json_wanted, rng):
    where = rng.random()
    interrupt_after = rng.random() * 0.8 if where < 0.05 else None
    run = Run(arguments, folder, json_wanted, interrupt_after is not None, 0.05 <= where < 0.08)
    (folder / "tmp").mkdir()
    before = set(folder.rglob("*"))
    with open("/dev/full" if run.full else folder / "stdout", "wb") as out, open(folder / "stderr", "wb") as err:
        began = time.monotonic()
        process = subprocess.Popen([command, *arguments], cwd=folder, stdin=subprocess.DEVNULL, stdout=out, stderr=err,
                                   env={**os.environ, "TMPDIR": str(folder / "tmp")},
                                   start_new_session=True, preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CORE, (0, 0)))
        while process.poll() is None:
            run.resident = max(run.resident, resident_mib(process))
            run.cpu = max(run.cpu, cpu_seconds(process))
            elapsed = time.monotonic() - began
            if interrupt_after is not None and elapsed > interrupt_after:
                process.send_signal(rng.choice([signal.SIGINT, signal.SIGTERM]))
                interrupt_after = None
            if elapsed > MOST_WALL_SECONDS:
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


def broken_promise(run):
    """In words; None where all promises were kept."""
    if run.code < 0 and not (run.interrupted and -run.code in (signal.SIGINT, signal.SIGTERM)):
        return f"ended by signal {-run.code} after {run.seconds:.1f} s"
    if run.code >= 0 and run.code not in DOCUMENTED_EXITS:
        return f"exit code {run.code}"
    if b"internal error" in run.err():
        return "an internal error"
    if run.code > 0 and not run.err() and not run.out():
        return f"exit code {run.code} and not a word"
    if "conform" not in run.arguments and run.arguments[0] != "--timeout" and run.cpu > MOST_CPU_SECONDS:
        return f"{run.cpu:.1f} CPU seconds with --timeout {TIMEOUT_SECONDS}"
    if run.resident > MOST_RESIDENT_MIB:
        return f"{run.resident} MiB with --memory {MEMORY_MIB}M"
    if run.full and run.code == 0 and run.arguments[0] not in ("format", "emit") and "--types" not in run.arguments:
        return "exit code 0 with a standard output that cannot be written"
    if run.json_wanted and not run.full and run.code in (0, 1, 2, 3):
        try:
            json.loads(run.out())
        except ValueError as error:
            return f"exit code {run.code} and JSON that is none: {error}"
    if run.arguments[0] in ("conform", "--timeout") and (b"DIFFERS" in run.out() or b'"differs"' in run.out()):
        return "model and generated code differ"
    if run.left_running:
        return "a child was left running"
    out = run.folder / "out"
    strays = [path for path in run.fresh if out not in path.parents and path != out]
    if strays:
        return f"files outside of --out: {sorted(map(str, strays))[:3]}"
    if [path for path in run.fresh if ".part" in path.name or ".tmp" in path.name]:
        return "an unfinished file was left behind"
    return None


def one(command, seeds, seed, kept):
    rng = random.Random(seed)
    with tempfile.TemporaryDirectory(prefix="robochart-hostile-") as name:
        folder = pathlib.Path(name)
        arguments, json_wanted = lay_out(command, rng, seeds, folder)
        run = run_once(command, arguments, folder, json_wanted, rng)
        broken = broken_promise(run)
        code_words = None
        if broken:
            place = kept / str(seed)
            shutil.rmtree(place, ignore_errors=True)
            shutil.copytree(folder, place, symlinks=True)
            (place / "COMMAND").write_text(" ".join(arguments) + "\n" + broken + "\n")
            code_words = f"seed {seed}: {broken}: {' '.join(arguments)}"
        verb = "all" if arguments[0].startswith("--") else " ".join(arguments[:2] if arguments[0] == "emit" else arguments[:1])
        return f"{verb} {run.code}", code_words


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("command", help="the program")
    parser.add_argument("roots", nargs="+", help="folders with models and scripts")
    parser.add_argument("--inputs", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=0, help="of the first input; input N has seed SEED + N")
    parser.add_argument("--kept", type=pathlib.Path, default=pathlib.Path("build/hostile"))
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    options = parser.parse_args()
    options.kept.mkdir(parents=True, exist_ok=True)
    command = str((options.kept / "program").resolve())  # a build in the meantime changes nothing here
    shutil.copy2(options.command, command)
    seeds = Seeds.below(options.roots, command, options.jobs)
    print(f"mutated: model files: {len(seeds.models)} right, {len(seeds.wrong_models)} wrong; "
          f"scripts: {len(seeds.scripts)} right, {len(seeds.wrong_scripts)} wrong", flush=True)
    verbs, broken, lock = {}, 0, threading.Lock()
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for verb, words in pool.map(lambda n: one(command, seeds, options.seed + n, options.kept), range(options.inputs)):
            with lock:
                verbs[verb] = verbs.get(verb, 0) + 1
                done = sum(verbs.values())
                if done % 1000 == 0:
                    print(f"{done} inputs, {broken} broken promises", flush=True)
                if words:
                    broken += 1
                    print(words, flush=True)
    print("runs by verb and exit code: " + ", ".join(f"{verb}: {count}" for verb, count in sorted(verbs.items())))
    print(f"{options.inputs - broken} of {options.inputs} runs kept every promise")
    return 1 if broken else 0


if __name__ == "__main__":
    sys.exit(main())
