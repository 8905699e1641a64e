#!/usr/bin/env python3
"""Mutates real inputs and runs the whole command on them: every verb, under small limits, with hostile names, signals and
outputs that cannot be written.

What is promised of every run: it ends by itself with a documented exit code (0 to 4), within its limits of time and memory;
JSON that it prints is JSON; nothing is written outside its output folder, and nothing but finished files inside.
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


MUTATIONS = [change_bytes, cut, repeat_lines, remove_lines, other_word, other_word, swap_words, swap_words, swap_words, hostile_name,
             hostile_name, hostile_literal, hostile_literal, nest]


@dataclasses.dataclass
class Seeds:
    """The inputs that are mutated: folders of models and scripts, and the words they are made of."""
    models: list
    scripts: list
    words: dict

    @staticmethod
    def below(roots):
        models, scripts, words = set(), [], {"model": set(), "script": set()}
        for root in roots:
            for path in sorted(pathlib.Path(root).rglob("*")):
                if not path.is_file() or path.stat().st_size > 40_000:
                    continue
                if path.suffix in (".rct", ".assertions"):
                    models.add(path)
                    words["model"].update(WORD.findall(path.read_bytes()))
                elif path.suffix == ".csp":
                    scripts.append(path)
                    words["script"].update(WORD.findall(path.read_bytes()))
        return Seeds(sorted(models), scripts, {kind: sorted(found) for kind, found in words.items()})


def mutated(rng, path, words):
    text = path.read_bytes()
    for _ in range(rng.choice([1, 1, 1, 2, 3, 6])):
        text = rng.choice(MUTATIONS)(rng, text, words)
    return text


def lay_out(rng, seeds, folder):
    """Writes one mutated input into the folder; returns the arguments of the command and whether they ask for JSON."""
    limits = ["--timeout", str(TIMEOUT_SECONDS), "--memory", f"{MEMORY_MIB}M"]
    if rng.random() < 0.2:
        limits += ["--max-states", str(rng.choice([1, 10, 1000]))]
    json_wanted = rng.random() < 0.4
    if seeds.scripts and rng.random() < 0.35:
        seed = rng.choice(seeds.scripts)
        for beside in seed.parent.glob("*.csp"):  # files that it may include
            if beside.stat().st_size < 40_000:
                shutil.copyfile(beside, folder / beside.name)
        (folder / seed.name).write_bytes(mutated(rng, seed, seeds.words["script"]))
        how = rng.choice([[], [], [], ["--typecheck"], ["--types"], ["-b"]])
        if json_wanted and not how:
            how = ["--format", rng.choice(["json", "framed_json"])]
            json_wanted = how[1] == "json"
        else:
            json_wanted = False
        return ["cspm", *limits, *how, seed.name], json_wanted
    seed = rng.choice(seeds.models)
    model = folder / "model"
    model.mkdir()
    beside = sorted(path for path in seed.parent.iterdir() if path.suffix in (".rct", ".assertions") and path.stat().st_size < 40_000)
    for path in beside[:20]:
        shutil.copyfile(path, model / path.name)
    name = seed.name if rng.random() < 0.9 else rng.choice(HOSTILE_FILES) + seed.suffix
    if name != seed.name and (model / seed.name).exists():
        (model / seed.name).unlink()
    (model / name).write_bytes(mutated(rng, seed, seeds.words["model"]))
    verb = rng.choice([["validate"]] * 4 + [["check", "--core"]] * 5 + [["check"]] * 3 + [["emit", "csp"]] * 2 + [["emit", "cpp"]] * 3 +
                      [["conform"], ["emit", "monitor"], ["emit", "tests"], ["format"], []])
    if verb in ([], ["emit", "csp"], ["emit", "cpp"], ["emit", "monitor"], ["emit", "tests"]):
        limits += ["--out", "out"]
    inputs = [str(path) for path in sorted(model.iterdir())] if verb == ["format"] else ["model"]
    if verb == ["format"]:
        return ["format", *inputs], False
    if verb in (["validate"], ["check", "--core"], ["check"], ["conform"]) and json_wanted:
        return [*verb, *limits, "--format", "json", *inputs], True
    return [*verb, *limits, *inputs], False


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


def run_once(command, arguments, folder, json_wanted, rng):
    """What was broken, in words; None where all promises were kept."""
    where = rng.random()
    interrupt_after = rng.random() * 0.8 if where < 0.05 else None
    full = 0.05 <= where < 0.08
    out_path = folder / "stdout"
    before = {path for path in folder.rglob("*")}
    highest = cpu = 0
    with open("/dev/full" if full else out_path, "wb") as out, open(folder / "stderr", "wb") as err:
        began = time.monotonic()
        process = subprocess.Popen([command, *arguments], cwd=folder, stdin=subprocess.DEVNULL, stdout=out, stderr=err,
                                   start_new_session=True, preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CORE, (0, 0)))
        while process.poll() is None:
            highest = max(highest, resident_mib(process))
            cpu = max(cpu, cpu_seconds(process))
            elapsed = time.monotonic() - began
            if interrupt_after is not None and elapsed > interrupt_after:
                process.send_signal(rng.choice([signal.SIGINT, signal.SIGTERM]))
                interrupt_after = None
            if elapsed > MOST_WALL_SECONDS:
                os.killpg(process.pid, signal.SIGKILL)
            time.sleep(0.01 if elapsed < 1 else 0.05)
    code = process.returncode
    if code < 0 and not (where < 0.05 and -code in (signal.SIGINT, signal.SIGTERM)):
        return f"ended by signal {-code} after {time.monotonic() - began:.1f} s"
    if code not in DOCUMENTED_EXITS and code >= 0:
        return f"exit code {code}"
    if "conform" not in arguments and arguments[0] != "--timeout" and cpu > MOST_CPU_SECONDS:
        return f"{cpu:.1f} CPU seconds with --timeout {TIMEOUT_SECONDS}"
    if highest > MOST_RESIDENT_MIB:
        return f"{highest} MiB with --memory {MEMORY_MIB}M"
    if full and code == 0 and arguments[0] not in ("format", "emit"):
        return "exit code 0 with a standard output that cannot be written"
    if json_wanted and not full and code in (0, 1, 3):
        try:
            json.loads(out_path.read_bytes())
        except ValueError as error:
            return f"exit code {code} and JSON that is none: {error}"
    fresh = {path for path in folder.rglob("*")} - before - {out_path, folder / "stderr"}
    strays = [path for path in fresh if folder / "out" not in path.parents and path != folder / "out"]
    if strays:
        return f"files outside of --out: {sorted(map(str, strays))[:3]}"
    if [path for path in fresh if ".part" in path.name or ".tmp" in path.name]:
        return "an unfinished file was left behind"
    return None


def one(command, seeds, seed, kept):
    rng = random.Random(seed)
    with tempfile.TemporaryDirectory(prefix="robochart-hostile-") as name:
        folder = pathlib.Path(name)
        arguments, json_wanted = lay_out(rng, seeds, folder)
        broken = run_once(command, arguments, folder, json_wanted, rng)
        code_words = None
        if broken:
            place = kept / str(seed)
            shutil.rmtree(place, ignore_errors=True)
            shutil.copytree(folder, place, symlinks=True)
            (place / "COMMAND").write_text(" ".join(arguments) + "\n" + broken + "\n")
            code_words = f"seed {seed}: {broken}: {' '.join(arguments)}"
        return arguments[0], code_words


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("command", help="the program")
    parser.add_argument("roots", nargs="+", help="folders with models and scripts")
    parser.add_argument("--inputs", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=0, help="of the first input; input N has seed SEED + N")
    parser.add_argument("--kept", type=pathlib.Path, default=pathlib.Path("build/hostile"))
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    options = parser.parse_args()
    seeds = Seeds.below(options.roots)
    options.kept.mkdir(parents=True, exist_ok=True)
    command = str((options.kept / "program").resolve())  # a build in the meantime changes nothing here
    shutil.copy2(options.command, command)
    print(f"{len(seeds.models)} model files and {len(seeds.scripts)} scripts are mutated")
    verbs, broken, lock = {}, 0, threading.Lock()
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for verb, words in pool.map(lambda n: one(command, seeds, options.seed + n, options.kept), range(options.inputs)):
            with lock:
                verbs[verb] = verbs.get(verb, 0) + 1
                if words:
                    broken += 1
                    print(words, flush=True)
    print("runs: " + ", ".join(f"{verb} {count}" for verb, count in sorted(verbs.items())))
    print(f"{options.inputs - broken} of {options.inputs} runs kept every promise")
    return 1 if broken else 0


if __name__ == "__main__":
    sys.exit(main())
