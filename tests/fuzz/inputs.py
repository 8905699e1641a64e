# SPDX-License-Identifier: Apache-2.0
"""Makes the input of each run: the arguments of a verb, and a folder with a mutated input."""
import dataclasses
import re
import shutil
import subprocess

import mutations
import seeds as kept_seeds


@dataclasses.dataclass
class Input:
    arguments: list
    json_wanted: bool = False
    typed: bytes = b""  # on standard input
    accepted: bool = True  # the front end accepts the mutated text


class Workshop:
    """Makes the input of one run."""

    def __init__(self, rng, seeds, reader, folder, accepted, limits):
        self.rng, self.seeds, self.reader, self.folder = rng, seeds, reader, folder
        self.must_be_right = rng.random() < accepted
        self.limits = limits
        self.accepted = True

    def chance(self, probability):
        return self.rng.random() < probability

    def place(self, kind, where, changed=True):
        """Writes a seed of this kind and the files that it needs; mutates the seed if `changed`. Returns its name."""
        seed = self.seeds.pick(self.rng, kind, self.must_be_right or self.chance(0.9))
        where.mkdir(exist_ok=True)
        for each in seed.beside:
            shutil.copyfile(each, where / each.name)
        name = seed.path.name if self.chance(0.9) else self.rng.choice(mutations.HOSTILE_FILES) + seed.path.suffix
        if changed:
            self.mutate(kind, seed.path.read_bytes(), where, name)
        else:
            shutil.copyfile(seed.path, where / name)
        return name

    def mutate(self, kind, original, where, name):
        """Changes a text. If the result must be valid, tries up to 20 times until the front end accepts it."""
        rng, words = self.rng, self.seeds.words[kind]
        carefully = self.chance(0.5)
        attempts = 20 if self.must_be_right else 1
        for attempt in range(attempts):
            text = mutations.changed(rng, original, words, carefully or attempt > 1)
            (where / name).write_bytes(text)
            if text != original and self.reads(kind, where, name):
                return
        self.accepted = self.accepted and self.reads(kind, where, name)

    def reads(self, kind, where, name):
        if kind == "model":
            return self.reader.reads(kind, where.parent, where.name)
        return self.reader.reads(kind, where, name)

    def finished(self, arguments, json_wanted=False, typed=b""):
        return Input(arguments, json_wanted, typed, self.accepted)

    def few_states(self):
        return ["--max-states", str(self.rng.choice([1, 10, 1000]))] if self.chance(0.2) else []

    def answer(self, formats=("json",), files=("json",)):
        """The options for the format and the output files of the answer, and whether standard output is JSON."""
        arguments = []
        if self.chance(0.15):
            kind = self.rng.choice(files)
            arguments = [f"--{kind}", f"out/answer.{kind}"]
            (self.folder / "out").mkdir(exist_ok=True)
        if self.chance(0.4):
            chosen = self.rng.choice(formats)
            return [*arguments, "--format", chosen], chosen in ("json", "sarif")
        return arguments, False


PROPERTIES = ["is deadlock-free", "is divergence-free", "is deterministic", "terminates", "is timelock-free", "is not deadlock-free"]
CLAIMS = ["assert {} :[deadlock free [F]]", "assert {} :[divergence free]", "assert {} :[deterministic [FD]]", "assert STOP [T= {}",
          "assert {0} [FD= {0}", "assert {} :[has trace]: <>", "print {}"]


def components(model):
    names = []
    for path in sorted(model.iterdir()):
        text = path.read_bytes().decode(errors="replace")
        package = re.match(r"\s*package\s+([\w:]+)", text)
        for name in re.findall(r"^\s*(?:stm|controller|module)\s+(\w+)", text, re.MULTILINE):
            names.append(f"{package[1]}::{name}" if package else name)
    return names


def claim_model(rng, model):
    """Adds claims to a model that has none."""
    names = components(model)
    if names and not any(path.suffix == ".assertions" for path in model.iterdir()):
        claims = [f"assertion Claim{i} : {rng.choice(names)} {rng.choice(PROPERTIES)}\n" for i in range(3)]
        (model / "claims.assertions").write_text("".join(claims))


def claim_script(shop, path):
    text = path.read_bytes()
    if re.search(rb"^\s*(?:assert|print)\b", text, re.MULTILINE):
        return
    types = subprocess.run([shop.reader.command, "cspm", "--types", path.name, "--timeout", "2"], cwd=path.parent,
                           stdin=subprocess.DEVNULL, capture_output=True, check=False).stdout.decode(errors="replace")
    processes = re.findall(r"^(\w+)\s*::?\s*Proc$", types, re.MULTILINE)
    names = processes or re.findall(r"^(\w+)\s*::?", types, re.MULTILINE)
    if names:
        claims = [shop.rng.choice(CLAIMS if processes else ["print {}"]).format(shop.rng.choice(names)) + "\n" for _ in range(3)]
        path.write_bytes(text + b"\n" + "".join(claims).encode())


# Verbs with a model.

def a_model(shop):
    shop.place("model", shop.folder / "model")
    return shop.folder / "model"


def validate(shop):
    a_model(shop)
    how, json_wanted = shop.answer(("json", "sarif"), ("json", "sarif"))
    return shop.finished(["validate", *shop.limits, *how, "model"], json_wanted)


def validate_and_fix(shop):
    a_model(shop)
    return shop.finished(["validate", "--fix", *shop.limits, "model"])


CHECKING = [["--timed"], ["--untimed"], ["--sizes"], ["--trace"], ["--range", "nat=0..3"], ["--range", "clock=0..2"],
            ["--scheduler", "uniform"], ["--exact"], ["--assertion", "1"], ["--assertion", "*"]]


def check(shop, *core):
    model = a_model(shop)
    if not core:
        claim_model(shop.rng, model)
    how, json_wanted = shop.answer(("json", "sarif", "junit"), ("json", "sarif", "junit", "html"))
    more = shop.rng.choice(CHECKING) if shop.chance(0.4) else []
    return shop.finished(["check", *core, *shop.limits, *shop.few_states(), *more, *how, "model"], json_wanted)


def verify(shop):
    a_model(shop)
    return shop.finished(["verify", *shop.limits, *shop.few_states(), "--out", "out", "model"])


TARGETS = [["--target", target] for target in ("library", "main", "ros2", "enki", "argos")] + [
    ["--choices"], ["--strategy", "switch"], ["--strategy", "table"]]


def emit(shop, what):
    a_model(shop)
    how, json_wanted = shop.answer()
    more = shop.rng.choice(TARGETS) if what == "cpp" and shop.chance(0.5) else []
    return shop.finished(["emit", what, *shop.limits, "--out", "out", *more, *how, "model"], json_wanted)


def emit_with_mapping(shop):
    name = shop.place("mapping", shop.folder / "model")
    return shop.finished(["emit", "cpp", *shop.limits, "--out", "out", "--target", "ros2", "--mapping", f"model/{name}", "model"])


def check_swarm(shop):
    name = shop.place("swarm", shop.folder / "model")
    how, json_wanted = shop.answer()
    return shop.finished(["check", *shop.limits, *shop.few_states(), "--swarm", f"model/{name}", *how, "model"], json_wanted)


COMPARING = [["--all-choices"], ["--model", "tick-tock"], ["--walks", "0"], ["--cycle", "3"], ["--trace"], ["--no-reduction"]]


def conform(shop):
    a_model(shop)
    how, json_wanted = shop.answer(("json", "junit"), ("json", "junit", "html"))
    more = shop.rng.choice(COMPARING) if shop.chance(0.5) else []
    return shop.finished(["conform", *shop.limits, *shop.few_states(), *more, *how, "model"], json_wanted)


def conform_to_log(shop):
    name = shop.place("log", shop.folder / "model")
    how, json_wanted = shop.answer()
    return shop.finished(["conform", *shop.limits, "--traces", f"model/{name}", *how, "model"], json_wanted)


def format_files(shop, *how):
    kind = shop.rng.choice(["model", "model", "rules"])
    shop.place(kind, shop.folder / "model")
    names = [f"model/{path.name}" for path in sorted((shop.folder / "model").iterdir())]
    return shop.finished(["format", *how, *names])


def draw(shop):
    a_model(shop)
    form = shop.rng.choice([["svg"], ["svg"], ["mermaid"], ["dot"]])
    return shop.finished(["draw", *shop.limits, "--format", *form, "--out", "out", "model"])


WALKING = ["1", "2", "tock", "tock 5", "undo", "undo 2", "random 20", "until e", "why", "find a", "way", "watch", "tree", "internal", "help",
           "99", "-1", "nonsense", "save out/way.trace", "load out/way.trace", "w", "\x1b[2J", "random 99999999999999999999"]


def step(shop):
    (shop.folder / "out").mkdir()
    typed = "\n".join(shop.rng.choice(WALKING) for _ in range(12)).encode() + b"\n"
    if shop.chance(0.3):
        name = shop.place("script", shop.folder / "model")
        found = re.findall(r"^([A-Z]\w*)(?:\(\d\))?\s*=", (shop.folder / "model" / name).read_bytes().decode(errors="replace"), re.MULTILINE)
        return shop.finished(["step", *shop.limits, f"model/{name}", shop.rng.choice(found or ["P"])], typed=typed)
    model = a_model(shop)
    html = ["--html", "out/page.html"] if shop.chance(0.2) else []
    return shop.finished(["step", *shop.limits, *html, "model", shop.rng.choice(components(model) or ["M"])], typed=typed)


# Rules.

def rules_alone(shop):
    name = shop.place("rules", shop.folder / "rules")
    how, json_wanted = shop.answer()
    more = shop.rng.choice([["--suggest"], ["--as-sleec-tk"], ["--without-limit", "now"]]) if shop.chance(0.3) else []
    return shop.finished(["rules", *shop.limits, *shop.few_states(), *more, *how, f"rules/{name}"], json_wanted)


RULES = ["when {a} then {b} within {n} seconds", "when {a} then not {b} within {n} seconds", "when {a} then {b}", "when {a} then {b} within {n} minutes",
         "when {a} then {b} within {n} seconds otherwise {c}", "when {a} and {m} then {b} within {n} seconds unless {m} then {c} within 1 seconds",
         "when {a} and (not {m}) then not {b} within {n} seconds unless {m}", "when {a} then {b} within {n} seconds unless ({m} or (not {m}))"]


def rules_about(rng, model):
    """Rules that use the names of a model."""
    text = b"".join(path.read_bytes() for path in sorted(model.iterdir())).decode(errors="replace")
    events = re.findall(r"\bevent\s+(\w+)", text) + re.findall(r"^\s*(\w+)\s*\(", text, re.MULTILINE) + ["unknown"]
    measures = re.findall(r"\bvar\s+(\w+)\s*:\s*boolean", text)
    chosen = [rng.choice(events) for _ in range(3)]
    measure = rng.choice(measures or ["near"])
    lines = ["def_start", *(f"\tevent {event}" for event in sorted(set(chosen))), f"\tmeasure {measure} : boolean", "def_end", "rule_start"]
    for number in range(rng.choice([1, 2, 4])):
        a, b, c = (rng.choice(chosen) for _ in range(3))
        lines.append(f"\tR{number} " + rng.choice(RULES).format(a=a, b=b, c=c, m=measure, n=rng.choice([0, 1, 2, 5, 60])))
    return "\n".join([*lines, "rule_end", ""]).encode()


def rules_with_model(shop):
    model = a_model(shop)
    name = "asked.sleec"
    text = rules_about(shop.rng, model)
    (shop.folder / name).write_bytes(text)
    if shop.chance(0.4):
        shop.mutate("rules", text, shop.folder, name)
    how, json_wanted = shop.answer()
    more = shop.rng.choice([["--as-sleec-tk"], ["--without-limit", "now"], ["--component", shop.rng.choice(components(model) or ["M"])],
                            ["--range", "nat=0..2"]]) if shop.chance(0.3) else []
    return shop.finished(["rules", *shop.limits, *shop.few_states(), *more, *how, name, "model"], json_wanted)


def emit_monitor_of_rules(shop):
    name = shop.place("rules", shop.folder / "rules")
    return shop.finished(["emit", "monitor", *shop.limits, "--out", "out", f"rules/{name}"])


# Scripts and models of other languages.

def cspm(shop):
    name = shop.place("script", shop.folder / "script")
    claim_script(shop, shop.folder / "script" / name)
    how = shop.rng.choice([[], [], [], ["--typecheck"], ["--types"], ["-b"]])
    json_wanted = False
    if not how and shop.chance(0.4):
        how = ["--format", shop.rng.choice(["json", "framed_json", "plain", "junit"])]
        json_wanted = how[1] == "json"
    return shop.finished(["cspm", *shop.limits, *shop.few_states(), *how, f"script/{name}"], json_wanted)


ASKED = ["P=? [ F x=1 ]", "Pmax=? [ F x>0 ]", "P>0.5 [ true U<=10 x=1 ]", "R=? [ F x=1 ]", "S=? [ x=0 ]", "E [ F x=1 ]", "filter(max, P=? [ X x=1 ])"]


def prism(shop):
    name = shop.place("prism", shop.folder / "chain")
    how, json_wanted = shop.answer(("json", "csv"))
    more = ["--property", shop.rng.choice(ASKED)] if shop.chance(0.7) else []
    if shop.chance(0.3):
        more += shop.rng.choice([["--exact"], ["--sim", "ci,samples=100"], ["--export", "tra"], ["--export", "dot"], ["--const", "N=1:3"],
                                 ["--export", "counterexample"]])
    if "--export" in more:
        how, json_wanted = [], False
    files = [f"chain/{name}"] + [f"chain/{path.name}" for path in (shop.folder / "chain").iterdir() if path.suffix == ".props"]
    return shop.finished(["prism", *shop.limits, *shop.few_states(), *more, *how, *files], json_wanted)


# Scenarios.

def shortened(text):
    """Changes a scenario so that it has few and short trials."""
    text = re.sub(rb"\b([\d.]+) s\b", lambda time: time.group() if time.group(1) in (b"0.01", b"0.1", b"1") else b"1 s", text)
    text = re.sub(rb"duration [\d.]+ s", b"duration 2 s", text)
    text = re.sub(rb"trials \d+", b"trials 3", text)
    return text if b"place at" in text else re.sub(rb"robots \d+ \{", b"robots 3 {", text)


CONSTANT = re.compile(r"\bconst\s+(\w+)\s*:\s*(nat|int|real|boolean)\b", re.MULTILINE)
TRIED = {"nat": ["1..5", "0,3", "1,2", "2..9"], "int": ["-2..2", "1,2,3"], "real": ["0.1..0.5", "0.25,0.5", "1..2"], "boolean": ["true,false"]}
ODD_VALUES = ["2", "-1..1", "0..99999999999", "1e999", "", "1..", "5..1", "true", "0.1..0.10000000000001", "nan"]


def open_constant(rng, model):
    """Replaces a number in a machine by a constant, if the model has no constant."""
    texts = {path: path.read_bytes().decode(errors="replace") for path in sorted(model.iterdir()) if path.suffix == ".rct"}
    if any(CONSTANT.search(text) for text in texts.values()):
        return
    for path, text in texts.items():
        machine = re.search(r"^\s*stm\s+\w+\s*\{", text, re.MULTILINE)
        numbers = list(re.finditer(r"(?<=[=<>(] )[\d.]+|(?<=[=(])[\d.]+(?=[),\s])", text[machine.end():])) if machine else []
        if numbers:
            number = rng.choice(numbers)
            body = text[machine.end():]
            path.write_text(f"{text[:machine.end()]} const tuned : real = {number.group()}\n"
                            f"{body[:number.start()]}tuned{body[number.end():]}")
            return


def claim_scenario(text):
    """Adds a claim to a scenario that has none."""
    if b"probability" in text or b"}" not in text:
        return text
    end = text.rindex(b"}")
    claim = b"measure together is cluster(20 cm)\naccept probability together >= 50 % within 1 s >= 10 % with confidence 90 %\n"
    return text[:end] + claim + text[end:]


def a_scenario(shop, tuned):
    """A scenario with its model; the scenario, the model or both are mutated."""
    folder = shop.folder / "world"
    what = shop.rng.choice(["model", "scenario", "both"])
    name = shop.place("scenario", folder, changed=what != "model")
    text = shortened((folder / name).read_bytes())
    (folder / name).write_bytes(claim_scenario(text) if tuned else text)
    if tuned:
        open_constant(shop.rng, folder)
    models = [path for path in sorted(folder.iterdir()) if path.suffix == ".rct"]
    if models and what != "scenario":
        chosen = shop.rng.choice(models)
        shop.mutate("model", chosen.read_bytes(), folder, chosen.name)
    return folder, name


def simulate(shop):
    folder, name = a_scenario(shop, False)
    how, json_wanted = shop.answer(("json",), ("json", "html"))
    more = shop.rng.choice([["--monitor"], ["--log", "out/log"], ["--no-pictures"], ["--trials", "2"]]) if shop.chance(0.5) else []
    return shop.finished(["simulate", *shop.limits, "--out", "out", *more, *how, f"{folder.name}/{name}"], json_wanted)


def tune(shop):
    folder, name = a_scenario(shop, True)
    text = "".join(path.read_bytes().decode(errors="replace") for path in sorted(folder.iterdir()) if path.suffix == ".rct")
    values = [["--const", f"{constant}={shop.rng.choice(ODD_VALUES if shop.chance(0.05) else TRIED[kind])}"]
              for constant, kind in CONSTANT.findall(text)][:3]
    how, json_wanted = shop.answer()
    return shop.finished(["tune", *shop.limits, "--out", "out", "--budget", shop.rng.choice(["5", "40", "60", "60"]),
                          *(word for value in values for word in value), *how, f"{folder.name}/{name}"], json_wanted)


# An editor.

METHODS = ["codeAction", "completion", "declaration", "definition", "documentHighlight", "documentSymbol", "foldingRange", "formatting",
           "hover", "prepareRename", "references", "rename", "semanticTokens/full", "signatureHelp", "codeLens", "diagnostic", "inlayHint",
           "prepareCallHierarchy", "selectionRange"]


def edit(shop):
    kind = shop.rng.choice(["model", "model", "script", "rules", "scenario", "mapping", "swarm"])
    name = shop.place(kind, shop.folder / "open")
    uri = (shop.folder / "open" / name).resolve().as_uri()
    text = (shop.folder / "open" / name).read_bytes().decode(errors="replace")
    calls = [("initialize", {"capabilities": {}, "rootUri": (shop.folder / "open").resolve().as_uri()}), ("initialized", None),
             ("textDocument/didOpen", {"textDocument": {"uri": uri, "languageId": "", "version": 1, "text": text}})]
    lines = text.split("\n")
    for number in range(8):
        if shop.chance(0.3):
            changed = mutations.changed(shop.rng, text.encode(), shop.seeds.words[kind], True).decode(errors="replace")
            calls.append(("textDocument/didChange", {"textDocument": {"uri": uri, "version": number + 2}, "contentChanges": [{"text": changed}]}))
        line = shop.rng.randrange(len(lines))
        place = {"line": line, "character": shop.rng.randrange(len(lines[line]) + 2)}
        calls.append((f"textDocument/{shop.rng.choice(METHODS)}",
                      {"textDocument": {"uri": uri}, "position": place, "positions": [place], "range": {"start": place, "end": place},
                       "context": {"includeDeclaration": True, "diagnostics": []}, "options": {"tabSize": 4, "insertSpaces": False},
                       "newName": shop.rng.choice(["renamed", "int", "", "a b"])}))
    stream = kept_seeds.messages([*calls, ("shutdown", {}), ("exit", None)])
    if shop.chance(0.1):
        stream = mutations.changed(shop.rng, stream, shop.seeds.words[kind], False)
    return shop.finished(["lsp"], typed=stream)


# By the names that --verbs accepts: the default weight of the verb, and the function that makes its input.
VERBS = {
    "validate": (3, validate),
    "validate --fix": (1, validate_and_fix),
    "check": (5, check),
    "check --core": (6, lambda shop: check(shop, "--core")),
    "check --swarm": (1, check_swarm),
    "verify": (1, verify),
    "emit csp": (3, lambda shop: emit(shop, "csp")),
    "emit cpp": (4, lambda shop: emit(shop, "cpp")),
    "emit cpp --mapping": (1, emit_with_mapping),
    "emit prism": (2, lambda shop: emit(shop, "prism")),
    "emit monitor": (3, lambda shop: emit(shop, "monitor")),
    "emit monitor RULES": (1, emit_monitor_of_rules),
    "emit tests": (1, lambda shop: emit(shop, "tests")),
    "conform": (2, conform),
    "conform --traces": (1, conform_to_log),
    "cspm": (12, cspm),
    "prism": (4, prism),
    "rules": (3, rules_alone),
    "rules MODEL": (3, rules_with_model),
    "step": (2, step),
    "draw": (2, draw),
    "simulate": (1, simulate),
    "tune": (1, tune),
    "format": (1, format_files),
    "format --check": (1, lambda shop: format_files(shop, "--check")),
    "format --diff": (1, lambda shop: format_files(shop, "--diff")),
    "lsp": (3, edit),
}
