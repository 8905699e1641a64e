# Completion of robochart-verify for bash: source this file, or copy it to /usr/share/bash-completion/completions as
# `robochart-verify`.
#
# Verbs, options and their choices are read from `robochart-verify --help`, so they are those of the program in use.

# The verbs in a help text.
_robochart_verify_verbs() {
  sed -n '/^Subcommands:/,/^$/s/^  \([a-z][a-z-]*\).*/\1/p' <<<"$1"
}

# The options in a help text: `-q,--quiet`, `--out DIR`.
_robochart_verify_options() {
  grep -oE '^  -[^ ]+' <<<"$1" | tr -d ' ' | tr ',' '\n'
}

# What may follow an option: the words of `{a,b}` in its line, or of `a, b or c` in its explanation; nothing if it takes
# something else.
_robochart_verify_choices() {
  local line
  line="$(grep -E -- "^  ([^ ]+,)?$2 [A-Z]" <<<"$1")"
  case "$line" in
    *'{'*'}'*) sed 's/.*{\(.*\)}.*/\1/' <<<"$line" | tr ',' '\n' ;;
    *' or '*) grep -oE '[a-z]+(, [a-z]+)* or [a-z]+$' <<<"$line" | sed 's/, / /g; s/ or / /' | tr ' ' '\n' ;;
  esac
}

# Does an option take a value?
_robochart_verify_takes_value() {
  grep -qE -- "^  ([^ ]+,)?$2 [A-Z]+[ =.]" <<<"$1"
}

_robochart_verify() {
  local program="${COMP_WORDS[0]}" current="${COMP_WORDS[COMP_CWORD]}" before="${COMP_WORDS[COMP_CWORD - 1]}"
  local help verbs words="" index
  local -a path=()
  COMPREPLY=()
  help="$("$program" --help 2>/dev/null)" || return 0
  for ((index = 1; index < COMP_CWORD; index++)); do
    verbs="$(_robochart_verify_verbs "$help")"
    grep -qxF -- "${COMP_WORDS[index]}" <<<"$verbs" || break
    path+=("${COMP_WORDS[index]}")
    help="$("$program" "${path[@]}" --help 2>/dev/null)" || return 0
  done
  # The first word of all may be a model: then it is `verify`.
  if [ "${#path[@]}" -eq 0 ] && [ "$COMP_CWORD" -gt 1 ]; then
    help="$("$program" verify --help 2>/dev/null)" || return 0
  fi
  if [ "$COMP_CWORD" -gt 1 ] && _robochart_verify_takes_value "$help" "$before"; then
    words="$(_robochart_verify_choices "$help" "$before")"
    if [ -n "$words" ]; then
      mapfile -t COMPREPLY < <(compgen -W "$words" -- "$current")
    elif [ "$before" = --out ]; then
      mapfile -t COMPREPLY < <(compgen -d -- "$current")
    fi
    return 0
  fi
  case "$current" in
    -*) mapfile -t COMPREPLY < <(compgen -W "$(_robochart_verify_options "$help")" -- "$current") ;;
    *)
      words="$(_robochart_verify_verbs "$help")"
      mapfile -t COMPREPLY < <(compgen -W "$words" -- "$current"; compgen -f -- "$current")
      ;;
  esac
}

complete -o filenames -F _robochart_verify robochart-verify
