# Completion of robochart-verify for bash, made by `robochart-verify help --generate bash`.
_robochart_verify_verbs='verify init validate check emit conform cspm prism rules step draw simulate format explain lsp help version'
_robochart_verify_emitted='csp cpp prism monitor tests'

# The options of a verb.
_robochart_verify_options() {
  case "$1" in
    'verify') echo '--assertion --timed --untimed --core --sizes --encoding --scheduler --exact --epsilon --seed --const --range --prefs --print --allow --deny-warnings --component --cycle -o --out --format --html --color -q --quiet --trace --progress --memory --timeout --threads --no-reduction --max-states --no-cache -h --help' ;;
    'init') echo '--simulation --ros2 -h --help' ;;
    'validate') echo '--allow --deny-warnings --fix --format --color -q --quiet --memory --timeout -h --help' ;;
    'check') echo '--assertion --timed --untimed --core --sizes --encoding --scheduler --exact --epsilon --seed --const --range --prefs --print --allow --deny-warnings -o --out --format --html --color -q --quiet --trace --progress --memory --timeout --threads --no-reduction --checkpoint --every --resume --disk --max-states --no-cache -h --help' ;;
    'emit csp') echo '--timed --untimed --core --const --range --print --allow --deny-warnings -o --out --format --color -q --quiet --progress --memory --timeout --threads --no-reduction --max-states --no-cache -h --help' ;;
    'emit cpp') echo '--const --range --print --allow --deny-warnings --component --cycle --target --mapping --strategy --choices -o --out --format --color -q --quiet --progress --memory --timeout --threads --no-reduction --max-states --no-cache -h --help' ;;
    'emit prism') echo '--range --prefs --print --allow --deny-warnings --component -o --out --format --color -q --quiet --progress --memory --timeout --threads --no-reduction --max-states --no-cache -h --help' ;;
    'emit monitor') echo '--const --range --print --allow --deny-warnings --component --cycle -o --out --format --color -q --quiet --progress --memory --timeout --threads --no-reduction --max-states --no-cache -h --help' ;;
    'emit tests') echo '--const --range --print --allow --deny-warnings --component --cycle --extra-states -o --out --format --color -q --quiet --progress --memory --timeout --threads --no-reduction --max-states --no-cache -h --help' ;;
    'conform') echo '--const --range --print --allow --deny-warnings --component --cycle --all-choices --model --walks --export --traces -o --out --format --html --color -q --quiet --trace --progress --memory --timeout --threads --no-reduction --max-states --no-cache -h --help' ;;
    'cspm') echo '--assertion --typecheck --types --format --color -q --quiet -b --brief --reveal-taus --split --export --progress --memory --timeout --threads --no-reduction --checkpoint --every --resume --disk --max-states --no-cache -h --help' ;;
    'prism') echo '--property --exact --epsilon --sim --scheduler --seed --const --allow --format --plot --color -q --quiet --export --memory --timeout --threads --max-states -h --help' ;;
    'rules') echo '--without-limit --as-sleec-tk --suggest --const --range --allow --deny-warnings --component --format --color -q --quiet --progress --memory --timeout --threads --no-reduction --max-states --no-cache -h --help' ;;
    'step') echo '--untimed --const --range --allow --deny-warnings --html --color --memory --timeout -h --help' ;;
    'draw') echo '--allow --deny-warnings -o --out --format --theme --color -q --quiet --memory --timeout -h --help' ;;
    'simulate') echo '--const --allow --deny-warnings --trials --seed --compare --monitor --log --no-pictures -o --out --format --html --color -q --quiet --progress --memory --timeout --threads --no-cache -h --help' ;;
    'format') echo '--check --diff --assertions --color -q --quiet --memory --timeout -h --help' ;;
    'explain') echo '--color -h --help' ;;
    'lsp') echo '--stdio -h --help' ;;
    'help') echo '--generate -h --help' ;;
    'version') echo '-h --help' ;;
    *) echo '-h --help --version' ;;
  esac
}

# What a verb's option takes: its choices, or of which kind it is; nothing if it takes no word.
_robochart_verify_argument() {
  case "$1 $2" in
    'verify --assertion' | 'check --assertion') echo '<value>' ;;
    'cspm --assertion') echo '<value>' ;;
    'prism --property') echo '<value>' ;;
    'verify --encoding' | 'check --encoding') echo 'csp robotool' ;;
    'verify --scheduler' | 'check --scheduler') echo 'any urgent uniform' ;;
    'verify --epsilon' | 'check --epsilon' | 'prism --epsilon') echo '<value>' ;;
    'prism --sim') echo '<value>' ;;
    'prism --scheduler') echo 'uniform' ;;
    'verify --seed' | 'check --seed' | 'prism --seed') echo '<value>' ;;
    'rules --without-limit') echo 'eventually now' ;;
    'prism --const') echo '<value>' ;;
    'verify --const' | 'check --const' | 'emit csp --const' | 'emit cpp --const' | 'emit monitor --const' | 'emit tests --const' | 'conform --const' | 'rules --const' | 'step --const' | 'simulate --const') echo '<value>' ;;
    'verify --range' | 'check --range' | 'emit csp --range' | 'emit cpp --range' | 'emit prism --range' | 'emit monitor --range' | 'emit tests --range' | 'conform --range' | 'rules --range' | 'step --range') echo '<value>' ;;
    'verify --prefs' | 'check --prefs' | 'emit prism --prefs') echo '<file>' ;;
    'verify --print' | 'check --print' | 'emit csp --print' | 'emit cpp --print' | 'emit prism --print' | 'emit monitor --print' | 'emit tests --print' | 'conform --print') echo 'ast model ir script timed-script' ;;
    'verify --allow' | 'validate --allow' | 'check --allow' | 'emit csp --allow' | 'emit cpp --allow' | 'emit prism --allow' | 'emit monitor --allow' | 'emit tests --allow' | 'conform --allow' | 'prism --allow' | 'rules --allow' | 'step --allow' | 'draw --allow' | 'simulate --allow') echo '<value>' ;;
    'verify --component' | 'emit cpp --component' | 'emit prism --component' | 'emit monitor --component' | 'emit tests --component' | 'conform --component' | 'rules --component') echo '<value>' ;;
    'verify --cycle' | 'emit cpp --cycle' | 'emit monitor --cycle' | 'emit tests --cycle' | 'conform --cycle') echo '<value>' ;;
    'emit cpp --target') echo 'library main ros2 enki argos' ;;
    'emit cpp --mapping') echo '<file>' ;;
    'emit cpp --strategy') echo 'auto switch table' ;;
    'conform --model') echo 'failures-divergences tick-tock' ;;
    'conform --walks') echo '<value>' ;;
    'conform --export') echo '<file>' ;;
    'conform --traces') echo '<file>' ;;
    'emit tests --extra-states') echo '<value>' ;;
    'simulate --trials') echo '<value>' ;;
    'simulate --seed') echo '<value>' ;;
    'simulate --compare') echo '<file>' ;;
    'simulate --log') echo '<folder>' ;;
    'verify -o' | 'verify --out' | 'check -o' | 'check --out' | 'emit csp -o' | 'emit csp --out' | 'emit cpp -o' | 'emit cpp --out' | 'emit prism -o' | 'emit prism --out' | 'emit monitor -o' | 'emit monitor --out' | 'emit tests -o' | 'emit tests --out' | 'conform -o' | 'conform --out' | 'simulate -o' | 'simulate --out') echo '<folder>' ;;
    'draw -o' | 'draw --out') echo '<folder>' ;;
    'draw --format') echo 'svg png pdf mermaid dot' ;;
    'draw --theme') echo 'auto light dark' ;;
    'emit csp --format' | 'emit cpp --format' | 'emit prism --format' | 'emit monitor --format' | 'emit tests --format' | 'simulate --format') echo 'text json' ;;
    'verify --format' | 'check --format') echo 'text json sarif junit' ;;
    'conform --format') echo 'text json junit' ;;
    'validate --format') echo 'text json sarif' ;;
    'cspm --format') echo 'text plain json framed_json junit' ;;
    'prism --format') echo 'text json csv' ;;
    'rules --format') echo 'text json' ;;
    'verify --html' | 'check --html' | 'conform --html') echo '<file>' ;;
    'step --html') echo '<file>' ;;
    'simulate --html') echo '<file>' ;;
    'prism --plot') echo '<file>' ;;
    'verify --color' | 'validate --color' | 'check --color' | 'emit csp --color' | 'emit cpp --color' | 'emit prism --color' | 'emit monitor --color' | 'emit tests --color' | 'conform --color' | 'cspm --color' | 'prism --color' | 'rules --color' | 'step --color' | 'draw --color' | 'simulate --color' | 'format --color' | 'explain --color') echo 'auto always never' ;;
    'cspm --export') echo 'aut dot csp' ;;
    'prism --export') echo 'tra sta lab dot strategy counterexample' ;;
    'verify --progress' | 'check --progress' | 'emit csp --progress' | 'emit cpp --progress' | 'emit prism --progress' | 'emit monitor --progress' | 'emit tests --progress' | 'conform --progress' | 'cspm --progress' | 'rules --progress' | 'simulate --progress') echo 'auto json never' ;;
    'help --generate') echo 'man bash zsh fish' ;;
    'verify --memory' | 'validate --memory' | 'check --memory' | 'emit csp --memory' | 'emit cpp --memory' | 'emit prism --memory' | 'emit monitor --memory' | 'emit tests --memory' | 'conform --memory' | 'cspm --memory' | 'prism --memory' | 'rules --memory' | 'step --memory' | 'draw --memory' | 'simulate --memory' | 'format --memory') echo '<value>' ;;
    'verify --timeout' | 'validate --timeout' | 'check --timeout' | 'emit csp --timeout' | 'emit cpp --timeout' | 'emit prism --timeout' | 'emit monitor --timeout' | 'emit tests --timeout' | 'conform --timeout' | 'cspm --timeout' | 'prism --timeout' | 'rules --timeout' | 'step --timeout' | 'draw --timeout' | 'simulate --timeout' | 'format --timeout') echo '<value>' ;;
    'verify --threads' | 'check --threads' | 'emit csp --threads' | 'emit cpp --threads' | 'emit prism --threads' | 'emit monitor --threads' | 'emit tests --threads' | 'conform --threads' | 'cspm --threads' | 'rules --threads') echo '<value>' ;;
    'simulate --threads') echo '<value>' ;;
    'prism --threads') echo '<value>' ;;
    'check --checkpoint' | 'cspm --checkpoint') echo '<folder>' ;;
    'check --every' | 'cspm --every') echo '<value>' ;;
    'check --resume' | 'cspm --resume') echo '<folder>' ;;
    'check --disk' | 'cspm --disk') echo '<folder>' ;;
    'prism --max-states') echo '<value>' ;;
    'verify --max-states' | 'check --max-states' | 'emit csp --max-states' | 'emit cpp --max-states' | 'emit prism --max-states' | 'emit monitor --max-states' | 'emit tests --max-states' | 'conform --max-states' | 'cspm --max-states' | 'rules --max-states') echo '<value>' ;;
  esac
}

_robochart_verify() {
  local current="${COMP_WORDS[COMP_CWORD]}" before="" verb="" first=1 choices
  COMPREPLY=()
  [ "$COMP_CWORD" -gt 1 ] && before="${COMP_WORDS[COMP_CWORD - 1]}"
  # bash takes `--format=json` apart.
  if [ "$current" = = ]; then
    current=""
  elif [ "$before" = = ]; then
    before="${COMP_WORDS[COMP_CWORD - 2]}"
  fi
  if [ "$COMP_CWORD" -gt 1 ]; then
    verb="${COMP_WORDS[1]}"
    if [ "$verb" = emit ]; then
      [ "$COMP_CWORD" -gt 2 ] && verb="emit ${COMP_WORDS[2]}" && first=2
    elif [[ " $_robochart_verify_verbs " != *" $verb "* ]]; then
      verb=verify first=0  # the first word of all may be a model
    fi
  fi
  choices="$(_robochart_verify_argument "$verb" "$before")"
  case "$choices" in
    '') ;;
    '<file>') mapfile -t COMPREPLY < <(compgen -f -- "$current"); return 0 ;;
    '<folder>') mapfile -t COMPREPLY < <(compgen -d -- "$current"); return 0 ;;
    '<value>') return 0 ;;
    *) mapfile -t COMPREPLY < <(compgen -W "$choices" -- "$current"); return 0 ;;
  esac
  case "$current" in
    -*) mapfile -t COMPREPLY < <(compgen -W "$(_robochart_verify_options "$verb")" -- "$current") ;;
    *)
      local words=""
      [ -z "$verb" ] && words="$_robochart_verify_verbs"
      [ "$verb" = emit ] && words="$_robochart_verify_emitted"
      [ "$verb" = help ] && words="$_robochart_verify_verbs"
      if [ "$first" -lt "$COMP_CWORD" ] || [ -z "$verb" ]; then
        mapfile -t COMPREPLY < <(
          [ -n "$words" ] && compgen -W "$words" -- "$current"
          [ "$verb" = emit ] || [ "$verb" = help ] || compgen -f -- "$current"
        )
      fi
      ;;
  esac
}

complete -o filenames -F _robochart_verify robochart-verify
