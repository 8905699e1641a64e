#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# GNU `timeout -s KILL` returns before its command has ended.
#
# Expected: when `timeout` returns, the command that it has killed is gone, with its locks, devices and memory.
# Observed: `timeout` sends the signal to its whole process group, and SIGKILL cannot be ignored, so `timeout` kills
#   itself too. The shell continues while the kernel still ends the command: in most runs its lock is still held.
#   With `--foreground`, `timeout` signals the command alone and waits for it: the lock is free.
# Why it matters: a script that restarts a robot's controller after `timeout -s KILL` starts the new one while the old
#   one still holds the lock, the port or the motor's device. Use `--foreground`, or `kill -KILL` and `wait`.
# usage: findings/timeout-kill-returns-early.sh; needs Debian 12's apt to download two packages; exit code 0 if the
# behaviour is as described.
set -eu

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -q coreutils=9.1-1 util-linux=2.38.1-5+deb12u3 >/dev/null 2>&1
for package in *.deb; do dpkg -x "$package" .; done
bin=$folder/usr/bin
"$bin/timeout" --version | head -n 1
"$bin/flock" --version

runs=10

# Starts a command that holds the lock and 500 MB, kills it after a second, and requests the lock at once. Prints the
# number of runs in which the lock was still held.
held_locks() {
  held=0
  i=0
  while [ "$i" -lt "$runs" ]; do
    "$bin/timeout" "$@" -s KILL 1 "$bin/flock" -F lock "$folder/bin/dd" if=/dev/zero of=/dev/null bs=500M count=9999 \
      >/dev/null 2>&1 || true
    "$bin/flock" -n lock true || held=$((held + 1))
    "$bin/flock" lock true
    i=$((i + 1))
  done
  echo "$held"
}

group=$(held_locks 2>/dev/null)
foreground=$(held_locks --foreground 2>/dev/null)
echo "timeout -s KILL:              the lock was still held in $group of $runs runs"
echo "timeout --foreground -s KILL: the lock was still held in $foreground of $runs runs"
[ "$group" -gt 0 ] && [ "$foreground" -eq 0 ]
