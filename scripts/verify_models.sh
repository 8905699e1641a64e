#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Called by the GitHub action: runs the verb VERB on the models in MODEL with the options in OPTIONS, one per line. With
# JUNIT the verdicts go to that file, and the exit code is that of the verb. Words are passed unchanged.
set -euo pipefail
mapfile -t models < <(printf '%s\n' "${MODEL:?no model is named}" | sed '/^[[:space:]]*$/d')
mapfile -t options < <(printf '%s\n' "${OPTIONS:-}" | sed '/^[[:space:]]*$/d')
case "${VERB:-verify}" in
  verify | check | conform | validate) ;;
  *)
    echo "the verb ${VERB} is none of verify, check, conform, validate" >&2
    exit 4
    ;;
esac
if [ -z "${JUNIT:-}" ]; then
  exec robochart-verify "${VERB:-verify}" "${options[@]}" -- "${models[@]}"
fi
status=0
robochart-verify "${VERB:-verify}" --format junit "${options[@]}" -- "${models[@]}" > "$JUNIT" || status=$?
exit "$status"
