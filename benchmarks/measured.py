# SPDX-License-Identifier: Apache-2.0
"""Runs a program and measures the resources of this one child (wait4: other children do not count)."""

import os
import subprocess
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path
from typing import Optional, Union


@dataclass
class Child:
    exit: int
    output: str
    errors: str
    wall: float  # seconds
    cpu: float
    rss: int  # bytes, maximum

    def said(self) -> str:
        return self.output + self.errors


def run(command: list[str], folder: Optional[Union[str, Path]] = None) -> Child:
    # Uses files, because a full pipe would block the child.
    with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as err:
        begin = time.monotonic()
        child = subprocess.Popen(command, stdout=out, stderr=err, cwd=folder)
        _, status, usage = os.wait4(child.pid, 0)
        wall = time.monotonic() - begin
        child.returncode = os.waitstatus_to_exitcode(status)
        texts = []
        for stream in (out, err):
            stream.seek(0)
            texts.append(stream.read().decode(errors="replace"))
    return Child(child.returncode, *texts, wall, usage.ru_utime + usage.ru_stime, usage.ru_maxrss * 1024)
