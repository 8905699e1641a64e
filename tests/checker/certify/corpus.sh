#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Every claim of the corpus that holds is certified, except for the reasons in exceptions.txt. The certificates in the
# repository are those that the command writes, and they are certified. corpus.sh VERIFY CERTIFY REPOSITORY
set -eu
verify=$1 certify=$2 repository=$3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failed=0
decide() { # NAME, and the arguments of the command
  name=$1
  shift
  status=0
  "$verify" "$@" --no-cache --progress never --certify "$work/$name" > "$work/$name.txt" 2> "$work/$name.err" || status=$?
  if [ "$status" -gt 1 ]; then
    echo "$name: exit $status"
    cat "$work/$name.err"
    failed=1
  fi
  if [ -d "$work/$name" ]; then
    "$certify" --quiet "$work/$name" > "$work/$name.answers" || failed=1
    sed "s|^|$name: |" "$work/$name.answers"
  fi
}
for model in "$repository"/corpus/*/; do
  [ "$(basename "$model")" = false_claims ] || decide "$(basename "$model")" check "$model" --timeout 500
done
for script in "$repository"/tests/app/mpi/scripts/*.csp; do
  decide "$(basename "$script" .csp)" cspm "$script" --timeout 500
done
for stored in "$repository"/corpus/*/certificates/*/; do
  written=$work/$(basename "$(dirname "$(dirname "$stored")")")/$(basename "$stored")
  for file in specification.txt implementation.txt; do
    diff "$stored$file" "$written/$file" || failed=1
  done
  "$certify" --quiet "$stored" > "$work/answers" || failed=1
  sed "s|^|$stored: |" "$work/answers"
done
cat "$work"/*.txt | grep -o 'no certificate: .*' | LC_ALL=C sort -u > "$work/exceptions" || true
diff "$(dirname "$0")/exceptions.txt" "$work/exceptions" || failed=1
exit $failed
