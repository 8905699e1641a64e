#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Tests distributed searches with checkpoints in a folder (docs/scale.md): ends them in several ways, then resumes them
with other numbers of ranks and with threads of the command. The answers, figures and counterexamples must be those of
an uninterrupted run. Exits with 1 if there is a difference. With --sample only a limit ends the searches.

    keep_ranks.py COMMAND MPIEXEC PROGRAM FAULTY [--sample]"""

import json
import os
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from end_ranks import ranks_left

# 4^N states, and one more state after `last`, which all processes perform together, after 3 N steps.
SCRIPT = """channel a : {{0..{last}}}.{{0..3}}
channel last
ROUND(i, n) = a.i.n -> ROUND(i, (n + 1) % 4)
ONCE(i, n) = if n == 3 then last -> STOP else a.i.n -> ONCE(i, n + 1)
assert ||| i : {{0..{last}}} @ ROUND(i, 0) :[deadlock free [F]]
assert [| {{last}} |] i : {{0..{last}}} @ ONCE(i, 0) :[deadlock free [F]]
"""
FAILS, BAD_INPUT, INCONCLUSIVE = 1, 2, 3


class Kept:
    def __init__(self, command: str, mpiexec: str, program: str, folder: str, processes: int):
        self.command, self.mpiexec, self.program, self.folder = command, mpiexec, program, folder
        self.kept = os.path.join(folder, "kept")
        self.script = os.path.join(folder, "script.csp")
        Path(self.script).write_text(SCRIPT.format(last=processes - 1))
        self.environment = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
                                TMPDIR=folder)
        self.wrong = 0
        self.expected = self.results(self.run([command, *self.arguments("--checkpoint", folder + "/alone")]))

    def arguments(self, option: str, kept: str, *more: str) -> list[str]:
        return ["cspm", self.script, "--no-reduction", "--no-cache", "--format", "json", option, kept, *more]

    def here(self, *more: str) -> list[str]:
        """Starts a search if the folder is empty, otherwise resumes it."""
        return self.arguments("--resume" if os.path.exists(self.kept + "/questions") else "--checkpoint", self.kept,
                              *more)

    def mpirun(self, ranks: int, *more: str) -> list[str]:
        return [self.mpiexec, "--oversubscribe", "-n", str(ranks), self.program, *self.here(*more)]

    def run(self, command: list[str]) -> subprocess.CompletedProcess:
        return subprocess.run(command, capture_output=True, text=True, env=self.environment, check=False, timeout=300)

    @staticmethod
    def results(ran: subprocess.CompletedProcess) -> str:
        """The part of the output that must not depend on interruptions."""
        try:
            found = json.loads(ran.stdout)["results"]
        except (ValueError, KeyError):
            return f"exit {ran.returncode}\n{ran.stdout}{ran.stderr}"
        names = "answer", "visited_states", "visited_transitions", "visited_plys", "counterexamples"
        return f"exit {ran.returncode}\n" + "\n".join(str([each[name] for name in names]) for each in found)

    def expect(self, what: str, right: bool, seen: str) -> None:
        print(f"{what}: {'as expected' if right else 'wrong: ' + seen}", flush=True)
        self.wrong += not right

    def expect_end(self, what: str, ran: subprocess.CompletedProcess, code: int, words: str) -> None:
        self.expect(what, ran.returncode == code and words in ran.stdout + ran.stderr,
                    f"exit {ran.returncode}\n{ran.stdout}{ran.stderr}")

    def expect_results(self, what: str, ran: subprocess.CompletedProcess, code: int = FAILS) -> None:
        right = self.results(ran) == self.expected and ran.returncode == code and "begins anew" not in ran.stderr
        self.expect(what, right and not os.path.exists(self.kept), self.results(ran) + "\nnot\n" + self.expected)

    def wait_for_ranks(self) -> None:
        limit = time.monotonic() + 30
        while ranks_left(self.folder) and time.monotonic() < limit:
            time.sleep(0.02)

    def checkpoints(self) -> list[tuple[str, int, int, bool]]:
        """For each checkpoint its folder, its number, its number of ranks, and whether it is complete."""
        parts = {}
        for path in Path(self.kept).glob("search-*/checkpoint-*-of-*"):
            number, rank, _, of_all = path.name.removeprefix("checkpoint-").split("-")
            parts.setdefault((path.parent.name, int(number), int(of_all)), set()).add(rank)
        return [(*each, len(ranks) == each[2]) for each, ranks in parts.items()]

    def checkpoint_of(self, ranks: int) -> bool:
        """Whether the last checkpoint is complete and has this number of ranks."""
        found = max((each[1:] for each in self.checkpoints()), default=(0, 0, False))
        return found[1:] == (ranks, True)


def limits(kept: Kept) -> None:
    kept.expect_end("two ranks until a limit", kept.run(kept.mpirun(2, "--max-states", "1000")), INCONCLUSIVE,
                    "the limit of 1000 states was reached")
    kept.expect("their checkpoint", kept.checkpoint_of(2), "it is not there")
    kept.expect_end("two threads until a limit",
                    kept.run([kept.command, *kept.here("--threads", "2", "--max-states", "2000")]), INCONCLUSIVE,
                    "the limit of 2000 states was reached")
    kept.expect("the command's checkpoint", kept.checkpoint_of(2), "it is not there")
    kept.expect_end("two programs of two threads until a limit",
                    kept.run(kept.mpirun(2, "--threads", "2", "--max-states", "2500")), INCONCLUSIVE,
                    "the limit of 2500 states was reached")
    kept.expect("their checkpoint", kept.checkpoint_of(4), "it is not there")
    kept.expect_results("three ranks, on disk, to the end", kept.run(kept.mpirun(3, "--disk", kept.kept)))


def kills(kept: Kept, seed: int) -> None:
    """Kills mpirun, or one of its ranks, at random moments."""
    numbers = random.Random(seed)
    ended = went_on = 0
    for turn in range(24):
        ranks = numbers.randint(1, 4)
        before = sum(complete for *_, complete in kept.checkpoints())
        more = ["--every", "0.0002", *(["--disk", kept.kept] if numbers.random() < 0.5 else [])]
        child = subprocess.Popen(kept.mpirun(ranks, *more), stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                                 env=kept.environment)
        time.sleep(0.3 + 1.5 * numbers.random())
        victims = [child.pid] if turn % 2 == 0 else [int(each) for each in ranks_left(kept.folder)
                                                     if int(each) != child.pid]
        if child.poll() is None and victims:
            ended += 1
            try:
                os.kill(numbers.choice(victims), signal.SIGKILL)
            except ProcessLookupError:
                pass
        output, errors = child.communicate(timeout=120)
        kept.wait_for_ranks()
        went_on += before > 0 and "begins anew" not in errors
        if child.returncode in (0, BAD_INPUT) or "begins anew" in errors and kept.checkpoint_of(ranks):
            kept.expect(f"turn {turn} of seed {seed}", False, f"exit {child.returncode}\n{output}{errors}")
    kept.expect(f"{ended} kills", ended > 10, "too few")
    kept.expect(f"{went_on} runs from a checkpoint", went_on > 5, "too few")
    ran = kept.run(kept.mpirun(3))
    kept.expect("three ranks to the end", kept.results(ran) == kept.expected, kept.results(ran))


def interrupt(kept: Kept) -> None:
    """mpirun waits two seconds, sends SIGTERM to the ranks, and waits again before it kills them."""
    child = subprocess.Popen([kept.mpiexec, "--mca", "odls_base_sigkill_timeout", "2", *kept.mpirun(3)[1:],
                              "--progress", "json"], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                             env=kept.environment)
    while "searching" not in (line := child.stderr.readline()) and line:
        pass
    child.send_signal(signal.SIGTERM)
    output, errors = child.communicate(timeout=120)
    kept.wait_for_ranks()
    kept.expect("SIGTERM to mpirun", "the run was interrupted" in output and kept.checkpoint_of(3),
                f"exit {child.returncode}\n{output[:2000]}{errors[-2000:]}")
    kept.expect_results("two ranks to the end", kept.run(kept.mpirun(2)))


def deadline(kept: Kept, faulty: str) -> None:
    """The second rank works for longer than the first rank waits for it after a limit."""
    program = [faulty, "1", "30", "sleep", *kept.here("--timeout", "1.5")]
    kept.expect_end("a limit while a rank is at work", kept.run([kept.mpiexec, "--oversubscribe", "-n", "2", *program]),
                    INCONCLUSIVE, "the time limit was reached")
    kept.expect("its checkpoint", kept.checkpoint_of(2), "it is not there, or not complete")
    kept.expect_results("two ranks to the end", kept.run(kept.mpirun(2)))


def full_disk(kept: Kept) -> None:
    """Limits the files of the second rank to a few KiB. MPI itself would write larger files for shared memory."""
    program = [kept.program, *kept.here("--every", "0.000001")]
    ran = kept.run([kept.mpiexec, "--oversubscribe", "--mca", "btl", "self,tcp", "-n", "1", *program, ":", "-n", "1",
                    "sh", "-c", 'trap "" XFSZ; ulimit -f 8; exec "$@"', "sh", *program])
    kept.expect_end("a full disk at the second rank", ran, INCONCLUSIVE, "cannot write ")
    kept.expect_results("three ranks to the end", kept.run(kept.mpirun(3)))


def other_folder(kept: Kept) -> None:
    """A path that is a different folder for each rank."""
    folders = [os.path.join(kept.folder, name) for name in ("one", "two")]
    program = [kept.program, *kept.arguments("--checkpoint", "/proc/self/cwd/kept")]
    for what, words in (("a rank that finds no folder", "rank 1: No such file or directory"),
                        ("a rank that finds another folder", "rank 1: it is of another run")):
        for folder in folders:
            os.makedirs(folder, exist_ok=True)
        ran = kept.run([kept.mpiexec, "--oversubscribe", "-n", "1", "-wdir", folders[0], *program, ":", "-n", "1",
                        "-wdir", folders[1], *program])
        kept.expect_end(what, ran, BAD_INPUT, words)
        if not os.path.exists(folders[1] + "/kept"):
            shutil.move(folders[0] + "/kept", folders[1])


def main() -> int:
    command, mpiexec, program = (os.path.abspath(each) if "/" in each else each for each in sys.argv[1:4])
    faulty = os.path.abspath(sys.argv[4])
    sample = "--sample" in sys.argv[5:]
    with tempfile.TemporaryDirectory() as folder:
        kept = Kept(command, mpiexec, program, folder, 6 if sample else 8)
        kept.expect("a run that nobody ends", kept.expected.startswith(f"exit {FAILS}\n['holds'"), kept.expected)
        limits(kept)
        if not sample:
            deadline(kept, faulty)
            for part in (full_disk, other_folder):
                part(kept)
            with tempfile.TemporaryDirectory() as other:
                larger = Kept(command, mpiexec, program, other, 10)
                interrupt(larger)
                kept.wrong += larger.wrong
            kills(kept, random.randrange(1 << 30))
        return 1 if kept.wrong else 0


if __name__ == "__main__":
    sys.exit(main())
