#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Checks that a program uses no function of the C library that is newer than glibc 2.35 (Debian 12 has 2.36, Ubuntu
# 22.04 has 2.35). With --alone the program may need no other library. Arguments: [--alone] PROGRAM.
set -euo pipefail
alone=0
if [ "$1" = --alone ]; then
  alone=1
  shift
fi
newest="$(objdump -T "$1" | grep -oE 'GLIBC_[0-9]+(\.[0-9]+)+' | sed 's/GLIBC_//' | sort -V | tail -n 1)"
[ -n "$newest" ] || { echo "$1 names no version of the C library" >&2; exit 1; }
if [ "$(printf '%s\n2.35\n' "$newest" | sort -V | tail -n 1)" != 2.35 ]; then
  echo "$1 needs glibc $newest:" >&2
  objdump -T "$1" | grep "GLIBC_$newest" >&2
  exit 1
fi
if [ "$alone" -eq 1 ]; then
  others="$(objdump -p "$1" | awk '$1 == "NEEDED" { print $2 }' | grep -vE '^(libc\.so\.6|libm\.so\.6|ld-linux-x86-64\.so\.2)$' || true)"
  [ -z "$others" ] || { echo "$1 needs $others" >&2; exit 1; }
fi
echo "newest version of the C library used: $newest"
