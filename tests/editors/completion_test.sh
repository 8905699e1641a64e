#!/usr/bin/env bash
# The completion for bash offers what `--help` lists. Argument: the program.
set -euo pipefail
program="$1"
folder="$(cd "$(dirname "$0")/../.." && pwd)"
# shellcheck source=/dev/null
source "$folder/editors/completion/robochart-verify.bash"
failures=0

# What is offered for the last of the words, sorted, on one line.
offered() {
  COMP_WORDS=("$program" "$@")
  COMP_CWORD="$#"
  _robochart_verify
  printf '%s\n' "${COMPREPLY[@]}" | sort | tr '\n' ' ' | sed 's/ $//'
}

expect() {
  local expected="$1"
  shift
  local found
  found="$(offered "$@")"
  if [ "$found" != "$expected" ]; then
    echo "after '$*': offered '$found', expected '$expected'" >&2
    failures=$((failures + 1))
  fi
}

# Long options of a verb by another way than the completion's: all words of the help before its first blank line after
# `Options:` that begin a line's explanation.
options_of() {
  "$program" "$@" --help | sed -n '/^Options:/,/^$/p' | grep -oE '^  (-[a-z],)?--[a-z-]+' | grep -oE '\-\-[a-z-]+' |
    sort | tr '\n' ' ' | sed 's/ $//'
}

cd "$folder/corpus"
for verb in verify check conform cspm explain format 'emit csp' 'emit cpp'; do
  read -ra words <<<"$verb"
  options="$(options_of "${words[@]}")"
  [ "$(wc -w <<<"$options")" -ge 2 ] || { echo "$verb has no options" >&2; exit 1; }
  expect "$options" "${words[@]}" --
done
expect "$(options_of verify)" aggregation --  # a model as the first word is `verify`
expect "emit explain" e
expect "aggregation" check agg
expect "aggregation cpp csp false_claims monitor swarm_taxis tests" emit ""
expect "always auto never" check --color ""
expect "json" check --format j
expect "timed-script" check aggregation --print t
expect "" check --timeout ""
expect "aggregation false_claims swarm_taxis" check aggregation --out ""
[ "$failures" -eq 0 ] || { echo "$failures failures" >&2; exit 1; }
echo "the completion offers what --help lists"
