#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Times a cycle of generated code that folds three windows of a scan with 360 readings. Called by run.py windows.

Usage: scan_windows.py COMMAND [COMPILER]
"""
import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent


def main():
    command = sys.argv[1]
    compiler = sys.argv[2] if len(sys.argv) > 2 else "g++"
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        subprocess.run([command, "emit", "cpp", HERE / "models" / "scan_windows.rct", "--capacity", "scan=360",
                        "--out", folder, "--quiet"], check=True, stdout=subprocess.DEVNULL)
        subprocess.run([compiler, "-std=c++17", "-O2", "-Wall", "-Wextra", "-Wconversion", "-Werror",
                        HERE / "code" / "scan_windows.cpp", "-I", folder / "cpp" / "Detector", "-o",
                        folder / "windows"], check=True)
        subprocess.run([folder / "windows"], check=True)


if __name__ == "__main__":
    main()
