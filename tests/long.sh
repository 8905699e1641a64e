#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Runs a test that takes longer than a run of the test programs: random campaigns, mutants, fuzzing, browsers.
# usage: tests/long.sh NAME [ARGUMENT...]; without a name it lists them. The head of its file in tests/long describes the
# arguments.
set -euo pipefail
folder="$(dirname "$0")/long"
name="${1:-}"
if [ -n "$name" ] && [ -f "$folder/$(basename "$name").sh" ]; then
  exec "$folder/$(basename "$name").sh" "${@:2}"
fi
[ -z "$name" ] || echo "no long test is called $name" >&2
for file in "$folder"/*.sh; do
  printf '%-13s%s\n' "$(basename "$file" .sh)" "$(sed -n '3s/^# *//p' "$file")"
done
[ -z "$name" ]
