# Completion of robochart-verify for bash, made by `robochart-verify help --generate bash`.
_robochart_verify_verbs='verify init validate check emit conform cspm prism rules step draw simulate tune format explain lsp help version'
_robochart_verify_emitted='csp cpp prism monitor rst tests'
_robochart_verify_codes='C1 C10 C11 C2 C3 C4 C4w C6 C7 C8 C9 CE2 CLM-P01 CLM-P02 CLM-P03 CLM-P04 CLM-P05 CLM-T01 CLM-T02 CLM-T03 CLM-T04 CLM-T05 CLM-T06 CLM-T07 CLM-T08 CLM-T09 CLM-T10 CLM-T11 CLM-T12 CLM-T13 CLM-T14 CLM-T15 CLM-T16 CLM-T17 CSPM-P01 CSPM-P02 CSPM-P03 CSPM-P04 CSPM-P05 CSPM-P06 CSPM-P07 CSPM-P08 CSPM-P09 CSPM-P10 CSPM-P11 CSPM-P12 CSPM-P13 CSPM-P14 CSPM-P15 CSPM-P16 CSPM-P17 CSPM-P18 CSPM-T01 CSPM-T02 CSPM-T03 CSPM-T04 CSPM-T05 CSPM-T06 CSPM-T07 CSPM-T08 CSPM-T09 CSPM-T10 CSPM-T11 CSPM-T12 CSPM-T13 CSPM-T14 CSPM-T15 CSPM-T16 CSPM-T17 CSPM-T18 CSPM-T19 CSPM-T20 CSPM-T21 CSPM-T22 CSPM-T23 Cn1 Cn10 Cn11 Cn2 Cn3 Cn4 Cn5 Cn6 Cn7 Cn8 Cn9 DT FS1 FS2 FS3 I I1 I2 IJ1 IJ2 J1 J2 J3 M M1 M2 M3 O1 PARAM PJ1 PJ2 PJ3 PRISM-E01 PRISM-E02 PRISM-E03 PRISM-E04 PRISM-E05 PRISM-E06 PRISM-E07 PRISM-E08 PRISM-E09 PRISM-E10 PRISM-E11 PRISM-E12 PRISM-E13 PRISM-E14 PRISM-E15 PRISM-P01 PRISM-P02 PRISM-P03 PRISM-P04 PRISM-P05 PRISM-P06 PRISM-P07 PRISM-P08 PRISM-P09 PRISM-T01 PRISM-T02 PRISM-T03 PRISM-T04 PRISM-T05 PRISM-T06 PRISM-T07 PRISM-T08 PRISM-T09 PRISM-T10 PRISM-T11 PRISM-T12 PRISM-T13 PRISM-T14 PRISM-T15 PRISM-T16 PRISM-T17 PRISM-T18 PT1 PT2 RC-A01 RC-A02 RC-A03 RC-A04 RC-A05 RC-A06 RC-C01 RC-C02 RC-C03 RC-C04 RC-C06 RC-C07 RC-C08 RC-C09 RC-C10 RC-C11 RC-C12 RC-C13 RC-C14 RC-C15 RC-C17 RC-C18 RC-C21 RC-D01 RC-D02 RC-D03 RC-E01 RC-E02 RC-E03 RC-E04 RC-E05 RC-E06 RC-E07 RC-E08 RC-F01 RC-F02 RC-F03 RC-F04 RC-G01 RC-G03 RC-G04 RC-G05 RC-G07 RC-G08 RC-G10 RC-G11 RC-G12 RC-G13 RC-G14 RC-G15 RC-G16 RC-K01 RC-K02 RC-K03 RC-K04 RC-K05 RC-K06 RC-K07 RC-K08 RC-K09 RC-K10 RC-K11 RC-K12 RC-L01 RC-L02 RC-L03 RC-L04 RC-M01 RC-M02 RC-M03 RC-M04 RC-M05 RC-M06 RC-M07 RC-M08 RC-M09 RC-M10 RC-M11 RC-M12 RC-M13 RC-M14 RC-M15 RC-M16 RC-M17 RC-M18 RC-M19 RC-N01 RC-N02 RC-N03 RC-N04 RC-P01 RC-P02 RC-P03 RC-P04 RC-P05 RC-P06 RC-P07 RC-P08 RC-P09 RC-P10 RC-P11 RC-P12 RC-P13 RC-P14 RC-P15 RC-P16 RC-P17 RC-P18 RC-P19 RC-P20 RC-P21 RC-P22 RC-P23 RC-P24 RC-P25 RC-P26 RC-P27 RC-P28 RC-P29 RC-P30 RC-P31 RC-P32 RC-P33 RC-P34 RC-P35 RC-P36 RC-P37 RC-P38 RC-P39 RC-Q01 RC-Q02 RC-Q03 RC-Q04 RC-Q05 RC-Q06 RC-Q07 RC-Q08 RC-Q10 RC-Q11 RC-Q12 RC-Q13 RC-R01 RC-R02 RC-R03 RC-R04 RC-R05 RC-R06 RC-R07 RC-R08 RC-R09 RC-R10 RC-R11 RC-R12 RC-R13 RC-R14 RC-S01 RC-S02 RC-S03 RC-S04 RC-S05 RC-S10 RC-S11 RC-S12 RC-S13 RC-S14 RC-S15 RC-S16 RC-S17 RC-S18 RC-S19 RC-S20 RC-S21 RC-S22 RC-S23 RC-S24 RC-S25 RC-S26 RC-T01 RC-T02 RC-T03 RC-T04 RC-T05 RC-T06 RC-T07 RC-T08 RC-T09 RC-T10 RC-T11 RC-T12 RC-T13 RC-T14 RC-T15 RC-T16 RC-T17 RC-T18 RC-T19 RC-T20 RC-T21 RC-T22 RC-T23 RC-T24 RC-T25 RC-T26 RC-T27 RC-T28 RC-T29 RC-T30 RC-T31 RC-T32 RC-T33 RC-T34 RC-T35 RC-T36 RC-U01 RC-V01 RC-V02 RC-V03 RC-W01 RC-W02 RC-W03 RC-W04 RC-W05 RC-W06 RC-W07 RC-W08 RC-W09 RC-W10 RC-W11 RC-W12 RC-W13 RC-W14 RC-W15 RC-W16 RC-W17 RC-W18 RC-W19 RC-W20 RC-W21 RC-Y01 RC-Y02 RC-Y03 RC-Y04 RC-Y05 RC-Y06 RC-Y07 RC-Y08 RC-Y09 RC-Y10 RC-Y11 RC-Y12 RC-Y13 RC-Y14 RC-Y15 RC-Y16 RC-Y17 RC-Y18 RP1 RP2 RP3 S2 SLEEC-P01 SLEEC-P02 SLEEC-P03 SLEEC-P04 SLEEC-P05 SLEEC-P06 SLEEC-P07 SLEEC-P08 SLEEC-P09 SLEEC-P10 SLEEC-T01 SLEEC-T02 SLEEC-T03 SLEEC-T04 SLEEC-T05 SLEEC-T06 SLEEC-T07 SLEEC-T08 SLEEC-T09 STM1 STM10 STM3 STM4 STM6 STM7 STM8 STM9 T1 T2 TE1 TE2 TE3 TE4 TE5 TS1 TT1 Tg2 Tg5'
_robochart_verify_warnings='CSPM-P18 CSPM-T21 Cn11 PJ3 PRISM-E08 PRISM-E12 PT2 RC-A05 RC-A06 RC-C08 RC-C12 RC-C13 RC-E08 RC-F04 RC-K12 RC-M14 RC-M19 RC-N03 RC-N04 RC-P09 RC-P30 RC-P33 RC-P39 RC-Q07 RC-Q08 RC-Q10 RC-R08 RC-R12 RC-S17 RC-S18 RC-S25 RC-T11 RC-T21 RC-T31 RC-T36 RC-U01 RC-W01 RC-W02 RC-W03 RC-W04 RC-W05 RC-W06 RC-W07 RC-W08 RC-W09 RC-W10 RC-W11 RC-W12 RC-W13 RC-W14 RC-W15 RC-W16 RC-W17 RC-W18 RC-W19 RC-W20 RC-W21 RC-Y06 RC-Y07 RC-Y13 RC-Y14 RC-Y16 SLEEC-P08 SLEEC-P10 SLEEC-T03 SLEEC-T05 STM3 STM8'

# The options of a verb.
_robochart_verify_options() {
  case "$1" in
    'verify') echo '--assertion --timed --untimed --core --concrete --sizes --encoding --scheduler --exact --epsilon --seed --const --range --prefs --print --allow --deny-warnings --component --cycle -o --out --format --json --sarif --junit --html --color -q --quiet --provenance --trace --progress --memory --timeout --assertion-timeout --threads --no-reduction --max-states --no-cache -h --help' ;;
    'init') echo '--simulation --ros2 -h --help' ;;
    'validate') echo '--allow --deny-warnings --fix --format --json --sarif --color -q --quiet --memory --timeout -h --help' ;;
    'check') echo '--assertion --timed --untimed --core --concrete --sizes --swarm --robots --grid --encoding --scheduler --exact --epsilon --seed --const --range --prefs --print --allow --deny-warnings -o --out --format --json --sarif --junit --html --color -q --quiet --provenance --trace --progress --memory --timeout --assertion-timeout --threads --no-reduction --certify --checkpoint --every --resume --disk --max-states --no-cache -h --help' ;;
    'emit csp') echo '--timed --untimed --core --swarm --robots --grid --const --range --print --allow --deny-warnings -o --out --format --json --color -q --quiet --provenance --progress --memory --timeout --threads --no-reduction --max-states --no-cache -h --help' ;;
    'emit cpp') echo '--const --range --print --allow --deny-warnings --component --cycle --target --mapping --mapping-draft --license --maintainer --package-version --model-names --dispatch --strategy --capacity --choices -o --out --format --json --color -q --quiet --provenance --progress --memory --timeout --threads --no-reduction --max-states --no-cache -h --help' ;;
    'emit prism') echo '--range --prefs --print --allow --deny-warnings --component -o --out --format --json --color -q --quiet --provenance --progress --memory --timeout --threads --no-reduction --max-states --no-cache -h --help' ;;
    'emit monitor') echo '--const --range --print --allow --deny-warnings --component --cycle -o --out --format --json --color -q --quiet --provenance --progress --memory --timeout --threads --no-reduction --max-states --no-cache -h --help' ;;
    'emit rst') echo '--const --range --print --allow --deny-warnings --component --cycle -o --out --format --json --color -q --quiet --provenance --progress --memory --timeout --threads --no-reduction --max-states --no-cache -h --help' ;;
    'emit tests') echo '--const --range --print --allow --deny-warnings --component --cycle --extra-states -o --out --format --json --color -q --quiet --provenance --progress --memory --timeout --threads --no-reduction --max-states --no-cache -h --help' ;;
    'conform') echo '--concrete --const --range --print --allow --deny-warnings --component --cycle --all-choices --model --walks --export --traces -o --out --format --json --junit --html --color -q --quiet --provenance --trace --progress --memory --timeout --threads --no-reduction --certify --max-states --no-cache -h --help' ;;
    'cspm') echo '--assertion --typecheck --types --format --json --junit --color -q --quiet --provenance -b --brief --reveal-taus --split --export --progress --memory --timeout --assertion-timeout --threads --no-reduction --certify --checkpoint --every --resume --disk --max-states --no-cache -h --help' ;;
    'prism') echo '--property --exact --epsilon --sim --scheduler --seed --const --allow --format --json --plot --color -q --quiet --provenance --export --memory --timeout --threads --max-states -h --help' ;;
    'rules') echo '--without-limit --as-sleec-tk --suggest --const --range --allow --deny-warnings --component --format --json --color -q --quiet --provenance --progress --memory --timeout --threads --no-reduction --max-states --no-cache -h --help' ;;
    'step') echo '--untimed --const --range --allow --deny-warnings --html --color --memory --timeout -h --help' ;;
    'draw') echo '--allow --deny-warnings -o --out --format --theme --color -q --quiet --memory --timeout -h --help' ;;
    'simulate') echo '--const --allow --deny-warnings --trials --seed --compare --monitor --log --log-format --no-pictures -o --out --format --json --html --color -q --quiet --provenance --progress --memory --timeout --threads --no-cache -h --help' ;;
    'tune') echo '--const --range --allow --deny-warnings --budget --seed --test --verify-certificate -o --out --format --json --color -q --quiet --provenance --progress --memory --timeout --threads --no-reduction --max-states --no-cache -h --help' ;;
    'format') echo '--check --diff --assertions --color -q --quiet --memory --timeout -h --help' ;;
    'explain') echo '--color -h --help' ;;
    'lsp') echo '--stdio -h --help' ;;
    'help') echo '--generate -h --help' ;;
    'version') echo '--format -h --help' ;;
    *) echo '-h --help --version' ;;
  esac
}

# What a verb's option takes: its choices, or of which kind it is; nothing if it takes no word.
_robochart_verify_argument() {
  case "$1 $2" in
    'verify --assertion' | 'check --assertion' | 'cspm --assertion') echo '<value>' ;;
    'check --swarm' | 'emit csp --swarm') echo '<file>' ;;
    'check --robots' | 'emit csp --robots') echo '<value>' ;;
    'check --grid' | 'emit csp --grid') echo '<value>' ;;
    'prism --property') echo '<value>' ;;
    'verify --encoding' | 'check --encoding') echo 'csp robotool' ;;
    'verify --scheduler' | 'check --scheduler') echo 'any urgent uniform' ;;
    'verify --epsilon' | 'check --epsilon' | 'prism --epsilon') echo '<value>' ;;
    'prism --sim') echo '<value>' ;;
    'prism --scheduler') echo 'uniform' ;;
    'verify --seed' | 'check --seed' | 'prism --seed') echo '<value>' ;;
    'rules --without-limit') echo 'eventually now' ;;
    'prism --const') echo '<value>' ;;
    'verify --const' | 'check --const' | 'emit csp --const' | 'emit cpp --const' | 'emit monitor --const' | 'emit rst --const' | 'emit tests --const' | 'conform --const' | 'rules --const' | 'step --const' | 'simulate --const') echo '<value>' ;;
    'tune --const') echo '<value>' ;;
    'verify --range' | 'check --range' | 'emit csp --range' | 'emit cpp --range' | 'emit prism --range' | 'emit monitor --range' | 'emit rst --range' | 'emit tests --range' | 'conform --range' | 'rules --range' | 'step --range' | 'tune --range') echo '<value>' ;;
    'verify --prefs' | 'check --prefs' | 'emit prism --prefs') echo '<file>' ;;
    'verify --print' | 'check --print' | 'emit csp --print' | 'emit cpp --print' | 'emit prism --print' | 'emit monitor --print' | 'emit rst --print' | 'emit tests --print' | 'conform --print') echo 'ast model ir script timed-script' ;;
    'verify --allow' | 'validate --allow' | 'check --allow' | 'emit csp --allow' | 'emit cpp --allow' | 'emit prism --allow' | 'emit monitor --allow' | 'emit rst --allow' | 'emit tests --allow' | 'conform --allow' | 'prism --allow' | 'rules --allow' | 'step --allow' | 'draw --allow' | 'simulate --allow' | 'tune --allow') echo '<warning>' ;;
    'verify --component' | 'emit cpp --component' | 'emit prism --component' | 'emit monitor --component' | 'emit rst --component' | 'emit tests --component' | 'conform --component' | 'rules --component') echo '<value>' ;;
    'verify --cycle' | 'emit cpp --cycle' | 'emit monitor --cycle' | 'emit rst --cycle' | 'emit tests --cycle' | 'conform --cycle') echo '<value>' ;;
    'emit cpp --target') echo 'library main ros2 enki argos python' ;;
    'emit cpp --mapping') echo '<file>' ;;
    'emit cpp --license') echo '<value>' ;;
    'emit cpp --maintainer') echo '<value>' ;;
    'emit cpp --package-version') echo '<value>' ;;
    'emit cpp --dispatch') echo 'timer immediate' ;;
    'emit cpp --strategy') echo 'auto switch table' ;;
    'emit cpp --capacity') echo '<value>' ;;
    'conform --model') echo 'failures-divergences tick-tock' ;;
    'conform --walks') echo '<value>' ;;
    'conform --export') echo '<file>' ;;
    'conform --traces') echo '<file>' ;;
    'emit tests --extra-states') echo '<value>' ;;
    'simulate --trials') echo '<value>' ;;
    'simulate --seed') echo '<value>' ;;
    'tune --budget') echo '<value>' ;;
    'tune --seed') echo '<value>' ;;
    'tune --test') echo 'friedman t-test' ;;
    'tune --verify-certificate') echo '<file>' ;;
    'simulate --compare') echo '<file>' ;;
    'simulate --log') echo '<folder>' ;;
    'simulate --log-format') echo 'text mcap' ;;
    'verify -o' | 'verify --out' | 'check -o' | 'check --out' | 'emit csp -o' | 'emit csp --out' | 'emit cpp -o' | 'emit cpp --out' | 'emit prism -o' | 'emit prism --out' | 'emit monitor -o' | 'emit monitor --out' | 'emit rst -o' | 'emit rst --out' | 'emit tests -o' | 'emit tests --out' | 'conform -o' | 'conform --out' | 'simulate -o' | 'simulate --out' | 'tune -o' | 'tune --out') echo '<folder>' ;;
    'draw -o' | 'draw --out') echo '<folder>' ;;
    'draw --format') echo 'svg png pdf mermaid dot' ;;
    'draw --theme') echo 'auto light dark' ;;
    'emit csp --format' | 'emit cpp --format' | 'emit prism --format' | 'emit monitor --format' | 'emit rst --format' | 'emit tests --format' | 'simulate --format' | 'tune --format') echo 'text json' ;;
    'verify --format' | 'check --format') echo 'text json sarif junit' ;;
    'conform --format') echo 'text json junit' ;;
    'validate --format') echo 'text json sarif' ;;
    'cspm --format') echo 'text plain json framed_json junit' ;;
    'prism --format') echo 'text json csv' ;;
    'rules --format' | 'version --format') echo 'text json' ;;
    'verify --json' | 'validate --json' | 'check --json' | 'emit csp --json' | 'emit cpp --json' | 'emit prism --json' | 'emit monitor --json' | 'emit rst --json' | 'emit tests --json' | 'conform --json' | 'cspm --json' | 'prism --json' | 'rules --json' | 'simulate --json' | 'tune --json') echo '<file>' ;;
    'verify --sarif' | 'validate --sarif' | 'check --sarif') echo '<file>' ;;
    'verify --junit' | 'check --junit' | 'conform --junit' | 'cspm --junit') echo '<file>' ;;
    'verify --html' | 'check --html' | 'conform --html') echo '<file>' ;;
    'step --html') echo '<file>' ;;
    'simulate --html') echo '<file>' ;;
    'prism --plot') echo '<file>' ;;
    'verify --color' | 'validate --color' | 'check --color' | 'emit csp --color' | 'emit cpp --color' | 'emit prism --color' | 'emit monitor --color' | 'emit rst --color' | 'emit tests --color' | 'conform --color' | 'cspm --color' | 'prism --color' | 'rules --color' | 'step --color' | 'draw --color' | 'simulate --color' | 'tune --color' | 'format --color' | 'explain --color') echo 'auto always never' ;;
    'cspm --export') echo 'aut dot csp' ;;
    'prism --export') echo 'tra sta lab dot strategy counterexample' ;;
    'verify --progress' | 'check --progress' | 'emit csp --progress' | 'emit cpp --progress' | 'emit prism --progress' | 'emit monitor --progress' | 'emit rst --progress' | 'emit tests --progress' | 'conform --progress' | 'cspm --progress' | 'rules --progress' | 'simulate --progress' | 'tune --progress') echo 'auto json never' ;;
    'help --generate') echo 'man bash zsh fish' ;;
    'verify --memory' | 'validate --memory' | 'check --memory' | 'emit csp --memory' | 'emit cpp --memory' | 'emit prism --memory' | 'emit monitor --memory' | 'emit rst --memory' | 'emit tests --memory' | 'conform --memory' | 'cspm --memory' | 'prism --memory' | 'rules --memory' | 'step --memory' | 'draw --memory' | 'simulate --memory' | 'tune --memory' | 'format --memory') echo '<value>' ;;
    'verify --timeout' | 'validate --timeout' | 'check --timeout' | 'emit csp --timeout' | 'emit cpp --timeout' | 'emit prism --timeout' | 'emit monitor --timeout' | 'emit rst --timeout' | 'emit tests --timeout' | 'conform --timeout' | 'cspm --timeout' | 'prism --timeout' | 'rules --timeout' | 'step --timeout' | 'draw --timeout' | 'simulate --timeout' | 'tune --timeout' | 'format --timeout') echo '<value>' ;;
    'verify --assertion-timeout' | 'check --assertion-timeout' | 'cspm --assertion-timeout') echo '<value>' ;;
    'verify --threads' | 'check --threads' | 'emit csp --threads' | 'emit cpp --threads' | 'emit prism --threads' | 'emit monitor --threads' | 'emit rst --threads' | 'emit tests --threads' | 'conform --threads' | 'cspm --threads' | 'rules --threads') echo '<value>' ;;
    'simulate --threads' | 'tune --threads') echo '<value>' ;;
    'prism --threads') echo '<value>' ;;
    'check --certify' | 'conform --certify' | 'cspm --certify') echo '<folder>' ;;
    'check --checkpoint' | 'cspm --checkpoint') echo '<folder>' ;;
    'check --every' | 'cspm --every') echo '<value>' ;;
    'check --resume' | 'cspm --resume') echo '<folder>' ;;
    'check --disk' | 'cspm --disk') echo '<folder>' ;;
    'prism --max-states') echo '<value>' ;;
    'verify --max-states' | 'check --max-states' | 'emit csp --max-states' | 'emit cpp --max-states' | 'emit prism --max-states' | 'emit monitor --max-states' | 'emit rst --max-states' | 'emit tests --max-states' | 'conform --max-states' | 'cspm --max-states' | 'rules --max-states' | 'tune --max-states') echo '<value>' ;;
  esac
}

# Codes by their beginning, in small letters too.
_robochart_verify_code() {
  mapfile -t COMPREPLY < <(compgen -W "$1" -- "$2")
  [ "${#COMPREPLY[@]}" -gt 0 ] || mapfile -t COMPREPLY < <(compgen -W "$1" -- "${2^^}")
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
    '<warning>') _robochart_verify_code "$_robochart_verify_warnings" "$current"; return 0 ;;
    '<value>') return 0 ;;
    *) mapfile -t COMPREPLY < <(compgen -W "$choices" -- "$current"); return 0 ;;
  esac
  if [ "$verb" = explain ] && [[ "$current" != -* ]]; then
    _robochart_verify_code "$_robochart_verify_codes" "$current"
    return 0
  fi
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
