# SPDX-License-Identifier: Apache-2.0
"""The inputs that are mutated: files of the given folders and of the pages of rules, each with the other files that it needs."""
import dataclasses
import json
import pathlib
import re
import shutil
import subprocess
import tempfile
import threading

import mutations

LARGEST_SEED = 40_000
LONGEST_READING = 20  # seconds
MODEL = (".rct", ".assertions")

# The kinds of inputs: the extensions of their files, and the extensions of the files in the same folder that they need.
KINDS = {
    "model": (MODEL, ()),
    "script": ((".csp",), ()),
    "rules": ((".sleec",), ()),
    "prism": ((".prism",), ()),
    "scenario": ((".scenario",), (".rct",)),
    "swarm": ((".swarm",), (".rct",)),
    "mapping": ((".ros2",), (".rct",)),
    "log": ((".trace",), (".rct",)),
}
READ_BY_SERVER = ("scenario", "swarm", "mapping")
WRONG = "file:///read/~.scenario"


class Reader:
    """Asks the front end whether a text is valid."""

    def __init__(self, command):
        self.command = command

    def reads(self, kind, folder, name):
        if kind in READ_BY_SERVER:
            return self.server_reads((folder / name).read_bytes(), name)
        arguments, refused = {
            "model": (["validate", name], (1, 2, 3, 4)),
            "script": (["cspm", "--typecheck", name], (1, 2, 3, 4)),
            "rules": (["rules", "--max-states", "1", name], (2, 4)),
            "prism": (["prism", "--max-states", "1", name], (2, 4)),
            "log": (["conform", "--traces", name, "."], (2, 4)),
        }[kind]
        code = subprocess.run([self.command, *arguments, "--timeout", "2"], cwd=folder, stdin=subprocess.DEVNULL,
                              stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False).returncode
        return code >= 0 and code not in refused

    def server_reads(self, text, name):
        """Whether the language server finds no error in the text, without its model. The server reports nothing about valid
        texts. So an invalid text is opened after it: when its error is reported, the server has finished with both."""
        try:
            texts = [(f"file:///read/{name}", text.decode()), (WRONG, "scenario")]
        except UnicodeDecodeError:
            return False
        opened = [("textDocument/didOpen", {"textDocument": {"uri": uri, "languageId": "", "version": 1, "text": each}})
                  for uri, each in texts]
        with subprocess.Popen([self.command, "lsp"], stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL) as server:
            timer = threading.Timer(LONGEST_READING, server.kill)
            timer.start()
            server.stdin.write(messages([("initialize", {"capabilities": {}}), ("initialized", None), *opened]))
            server.stdin.flush()
            answer = b""
            while WRONG.encode() not in answer and (more := server.stdout.read1()):
                answer += more
            timer.cancel()
            server.kill()
        return answer.count(b"publishDiagnostics") == 1


NOTIFICATIONS = ("initialized", "exit", "textDocument/didOpen", "textDocument/didChange", "textDocument/didClose")


def messages(calls):
    """The bytes of these calls in the protocol of the language server."""
    stream = b""
    for number, (method, parameters) in enumerate(calls):
        message = {"jsonrpc": "2.0", "method": method, "params": parameters or {}}
        if method not in NOTIFICATIONS:
            message["id"] = number
        text = json.dumps(message).encode()
        stream += b"Content-Length: %d\r\n\r\n" % len(text) + text
    return stream


PAGE_ENDINGS = {"robochart": ".rct", "assertions": ".assertions", "cspm": ".csp", "prism": ".prism", "props": ".props",
                "sleec": ".sleec", "scenario": ".scenario", "swarm": ".swarm", "ros2": ".ros2"}
BLOCK = re.compile(r"^```(\w+)(?: file=(\S+))?\n(.*?)^```$", re.MULTILINE | re.DOTALL)


def unpack_pages(pages, folder):
    """Writes the examples of the pages of rules, each into its own folder."""
    for page in sorted(pages.glob("*.md")):
        for part, text in enumerate(re.split(r"^## (?:Wrong|Right)$", page.read_text(), flags=re.MULTILINE)[1:]):
            blocks = [(language, name, body) for language, name, body in BLOCK.findall(text) if language in PAGE_ENDINGS]
            for number, (language, name, body) in enumerate(blocks):
                target = folder / f"{page.stem}-{part}" / (name or f"example{number}{PAGE_ENDINGS[language]}")
                target.parent.mkdir(parents=True, exist_ok=True)
                target.write_text(body)


@dataclasses.dataclass
class Seed:
    path: pathlib.Path
    beside: list
    right: bool


class Seeds:
    """All seeds by kind, and the words that occur in the seeds of each kind."""

    def __init__(self, roots, reader):
        self.reader, self.known, self.paths, self.words = reader, {}, {}, {}
        for kind, (endings, _) in KINDS.items():
            self.paths[kind] = sorted({path for root in roots for path in pathlib.Path(root).rglob("*")
                                       if path.suffix in endings and path.is_file() and path.stat().st_size <= LARGEST_SEED})
            self.words[kind] = sorted({word for path in self.paths[kind] for word in mutations.WORD.findall(path.read_bytes())})

    def pick(self, rng, kind, right):
        """A random seed that is valid, or one that is invalid. If 50 attempts find none, returns the last seed."""
        for _ in range(50):
            seed = self.seed_of(kind, rng.choice(self.paths[kind]))
            if seed.right == right:
                break
        return seed

    def seed_of(self, kind, path):
        """The file alone if it is valid, otherwise with other files of its folder."""
        if path not in self.known:
            self.known[path] = self.find(kind, path)
        return self.known[path]

    def find(self, kind, path):
        endings, companions = KINDS[kind]
        beside = [other for other in sorted(path.parent.iterdir()) if other != path and other.suffix in endings + companions and
                  other.stat().st_size < LARGEST_SEED][:20]
        if companions:
            choices = [[other for other in beside if other.suffix in companions]]
        else:
            choices = [[], [other for other in beside if other.stem == path.stem], beside]
        for chosen in choices:
            with tempfile.TemporaryDirectory(prefix="robochart-hostile-") as name:
                folder = pathlib.Path(name)
                for each in [path, *chosen]:
                    shutil.copyfile(each, folder / each.name)
                if self.reader.reads(kind, folder, "." if kind == "model" else path.name):
                    return Seed(path, chosen, True)
        return Seed(path, choices[-1], False)

    def summary(self):
        return ", ".join(f"{len(paths)} of {kind}" for kind, paths in self.paths.items())
