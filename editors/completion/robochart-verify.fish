# Completion of robochart-verify for fish, made by `robochart-verify help --generate fish`.
set -g __robochart_verify_verbs verify init validate check emit conform cspm prism step draw simulate format explain lsp help version

# The verb of the command line, `emit` with what it writes; `none` before there is one.
function __robochart_verify_verb
    set -l words (commandline -opc)
    if test (count $words) -lt 2
        echo none
    else if test $words[2] = emit
        if test (count $words) -lt 3
            echo emit
        else
            echo "emit $words[3]"
        end
    else if contains -- $words[2] $__robochart_verify_verbs
        echo $words[2]
    else
        echo verify # the first word of all may be a model
    end
end

function __robochart_verify_is
    contains -- (__robochart_verify_verb) $argv
end

complete -c robochart-verify -n '__robochart_verify_is none help' -a verify -d 'everything: read, check assertions, export CSP, generate C++, conform (the default)'
complete -c robochart-verify -n '__robochart_verify_is none help' -a init -d 'write a new project: a small robot, and what is claimed of it'
complete -c robochart-verify -n '__robochart_verify_is none help' -a validate -d 'read the model and report what is wrong with it, nothing else'
complete -c robochart-verify -n '__robochart_verify_is none help' -a check -d 'read the model and decide its assertions'
complete -c robochart-verify -f -n '__robochart_verify_is emit' -a csp -d 'write the CSP semantics as scripts for FDR'
complete -c robochart-verify -f -n '__robochart_verify_is emit' -a cpp -d 'write the C++ controllers'
complete -c robochart-verify -f -n '__robochart_verify_is emit' -a prism -d 'write modules as PRISM models, in RoboTool\'s encoding'
complete -c robochart-verify -f -n '__robochart_verify_is emit' -a monitor -d 'write monitors: headers that follow a controller and report where it leaves its model'
complete -c robochart-verify -f -n '__robochart_verify_is emit' -a tests -d 'write finite complete test suites, and GoogleTest that replays them against an implementation'
complete -c robochart-verify -n '__robochart_verify_is none help' -a conform -d 'check generated C++ against the semantics, exhaustively'
complete -c robochart-verify -n '__robochart_verify_is none help' -a cspm -d 'decide the assertions of CSPM scripts'
complete -c robochart-verify -n '__robochart_verify_is none help' -a prism -d 'explore a PRISM model (dtmc, mdp) and decide its properties'
complete -c robochart-verify -n '__robochart_verify_is none help' -a step -d 'animate the semantics by hand: of a component, or of a process of a CSPM script'
complete -c robochart-verify -n '__robochart_verify_is none help' -a draw -d 'draw diagrams of a model, or of some of its components'
complete -c robochart-verify -n '__robochart_verify_is none help' -a simulate -d 'run a scenario\'s trials with the generated controllers: measures, bands, pictures'
complete -c robochart-verify -n '__robochart_verify_is none help' -a format -d 'write model and assertion files in the standard layout, in place'
complete -c robochart-verify -n '__robochart_verify_is none help' -a explain -d 'explain a rule by its code; without one, list all rules'
complete -c robochart-verify -n '__robochart_verify_is none help' -a lsp -d 'serve an editor over standard input and output (Language Server Protocol)'
complete -c robochart-verify -n '__robochart_verify_is none help' -a help -d 'show the help of a verb; write the man page, or a completion for a shell'
complete -c robochart-verify -n '__robochart_verify_is none help' -a version -d 'show the version'
complete -c robochart-verify -n '__robochart_verify_is none help' -a emit -d 'write files, nothing else'
complete -c robochart-verify -n '__robochart_verify_is "verify" "check"' -l assertion -x -d 'only the assertion of this name'
complete -c robochart-verify -n '__robochart_verify_is "cspm"' -l assertion -x -d 'only this assertion of each script, counted from 1'
complete -c robochart-verify -n '__robochart_verify_is "verify" "check" "emit csp"' -l timed -d 'only the timed semantics'
complete -c robochart-verify -n '__robochart_verify_is "verify" "check" "emit csp" "step"' -l untimed -d 'only the untimed semantics'
complete -c robochart-verify -n '__robochart_verify_is "verify" "check" "emit csp"' -l core -d 'also the core properties of every component; without it they are checked where the model has no assertions'
complete -c robochart-verify -n '__robochart_verify_is "verify" "check"' -l sizes -d 'print the number of states and transitions of every component'
complete -c robochart-verify -n '__robochart_verify_is "cspm"' -l typecheck -d 'check names and types and stop'
complete -c robochart-verify -n '__robochart_verify_is "cspm"' -l types -d 'print the type of every name and stop'
complete -c robochart-verify -n '__robochart_verify_is "prism"' -l property -x -d 'a property beside those of the files, for example \'P=? [ F "done" ]\''
complete -c robochart-verify -n '__robochart_verify_is "prism"' -l exact -d 'compute with fractions: exact values, for small models'
complete -c robochart-verify -n '__robochart_verify_is "prism"' -l epsilon -x -d 'how wide the interval around a value may be, relative to the value'
complete -c robochart-verify -n '__robochart_verify_is "prism"' -l const -x -d 'value of a constant left open, or values to try: LOW:HIGH, LOW:STEP:HIGH; several with commas'
complete -c robochart-verify -n '__robochart_verify_is "verify" "check" "emit csp" "emit cpp" "emit monitor" "emit tests" "conform" "step" "simulate"' -l const -x -d 'value of a constant the model leaves open'
complete -c robochart-verify -n '__robochart_verify_is "verify" "check" "emit csp" "emit cpp" "emit prism" "emit monitor" "emit tests" "conform" "step"' -l range -x -d 'carrier of nat, int or real; lengths of Seq, times of clock, elements of given'
complete -c robochart-verify -n '__robochart_verify_is "emit prism"' -l prefs -r -F -d 'RoboTool\'s preferences (rc2prism.prefs): the ranges of nat, int and real, the kind of model'
complete -c robochart-verify -n '__robochart_verify_is "verify" "check" "emit csp" "emit cpp" "emit prism" "emit monitor" "emit tests" "conform"' -l print -x -a 'ast model ir script timed-script' -d 'print a phase and stop'
complete -c robochart-verify -n '__robochart_verify_is "verify" "validate" "check" "emit csp" "emit cpp" "emit prism" "emit monitor" "emit tests" "conform" "prism" "step" "draw" "simulate"' -l allow -x -d 'leave out warnings of this code'
complete -c robochart-verify -n '__robochart_verify_is "verify" "validate" "check" "emit csp" "emit cpp" "emit prism" "emit monitor" "emit tests" "conform" "step" "draw" "simulate"' -l deny-warnings -d 'treat a model with warnings as wrong'
complete -c robochart-verify -n '__robochart_verify_is "verify" "emit cpp" "emit prism" "emit monitor" "emit tests" "conform"' -l component -x -d 'only this module, controller or machine'
complete -c robochart-verify -n '__robochart_verify_is "verify" "emit cpp" "emit monitor" "emit tests" "conform"' -l cycle -x -d 'time units of one control cycle'
complete -c robochart-verify -n '__robochart_verify_is "emit cpp"' -l target -x -a 'library main ros2 enki argos' -d 'a complete project, below DIR/TARGET/COMPONENT'
complete -c robochart-verify -n '__robochart_verify_is "emit cpp"' -l mapping -r -F -d 'with --target ros2: the messages and topics of operations, events and variables'
complete -c robochart-verify -n '__robochart_verify_is "emit cpp"' -l strategy -x -a 'auto switch table' -d 'how generated code selects what an event does: by a switch over states and events, or by a table; auto: a table from five states on'
complete -c robochart-verify -n '__robochart_verify_is "emit cpp"' -l choices -d 'code that asks its platform where the model leaves a choice (`pick`), instead of taking the first'
complete -c robochart-verify -n '__robochart_verify_is "conform"' -l all-choices -d 'where the model leaves a choice, explore every alternative, not only the first'
complete -c robochart-verify -n '__robochart_verify_is "conform"' -l model -x -a 'failures-divergences tick-tock' -d 'what is decided: refinement in failures-divergences, or in tick-tock, which records refusals before each tock'
complete -c robochart-verify -n '__robochart_verify_is "conform"' -l walks -x -d 'cycles of guided random walks where the state space is too large; 0 for none'
complete -c robochart-verify -n '__robochart_verify_is "conform"' -l export -r -F -d 'write all states of the code to this file, for other tools (.aut, .dot) or with the model for FDR (.csp)'
complete -c robochart-verify -n '__robochart_verify_is "conform"' -l traces -r -F -d 'compare logs of runs with the model, and no generated code; files, or folders with .trace files'
complete -c robochart-verify -n '__robochart_verify_is "emit tests"' -l extra-states -x -d 'states over control cycles that an implementation may have more than the model'
complete -c robochart-verify -n '__robochart_verify_is "simulate"' -l trials -x -d 'number of trials, instead of the scenario\'s'
complete -c robochart-verify -n '__robochart_verify_is "simulate"' -l seed -x -d 'seed of the first trial, instead of the scenario\'s'
complete -c robochart-verify -n '__robochart_verify_is "simulate"' -l monitor -d 'stop a trial where a robot does what its model does not allow'
complete -c robochart-verify -n '__robochart_verify_is "simulate"' -l log -x -a '(__fish_complete_directories)' -d 'write what every robot read and did in every cycle, for `conform --traces`'
complete -c robochart-verify -n '__robochart_verify_is "simulate"' -l no-pictures -d 'write no tables and pictures'
complete -c robochart-verify -n '__robochart_verify_is "validate"' -l fix -d 'apply certain fixes to the files, then report the remaining findings'
complete -c robochart-verify -n '__robochart_verify_is "format"' -l check -d 'write nothing; list the files that would change, exit 1 if there are any'
complete -c robochart-verify -n '__robochart_verify_is "format"' -l diff -d 'write nothing; show what would change'
complete -c robochart-verify -n '__robochart_verify_is "format"' -l assertions -d 'read standard input (-) as an assertion file'
complete -c robochart-verify -n '__robochart_verify_is "init"' -l simulation -d 'with a scenario for `simulate`'
complete -c robochart-verify -n '__robochart_verify_is "init"' -l ros2 -d 'with a mapping to messages of ROS 2 for `emit cpp --target ros2`'
complete -c robochart-verify -n '__robochart_verify_is "verify" "check" "emit csp" "emit cpp" "emit prism" "emit monitor" "emit tests" "conform" "simulate"' -s o -l out -x -a '(__fish_complete_directories)' -d 'folder for the files written'
complete -c robochart-verify -n '__robochart_verify_is "draw"' -s o -l out -x -a '(__fish_complete_directories)' -d 'folder for the diagrams; with one COMPONENT the file for its diagram, otherwise on standard output (-)'
complete -c robochart-verify -n '__robochart_verify_is "draw"' -l format -x -a 'svg png pdf mermaid dot' -d 'format of the diagrams; png and pdf need rsvg-convert'
complete -c robochart-verify -n '__robochart_verify_is "draw"' -l theme -x -a 'auto light dark' -d 'colours of the diagrams; auto: as the reader\'s system prefers'
complete -c robochart-verify -n '__robochart_verify_is "emit csp" "emit cpp" "emit prism" "emit monitor" "emit tests" "simulate"' -l format -x -a 'text json' -d 'how the result is printed'
complete -c robochart-verify -n '__robochart_verify_is "verify" "check"' -l format -x -a 'text json sarif junit' -d 'how the result is printed'
complete -c robochart-verify -n '__robochart_verify_is "conform"' -l format -x -a 'text json junit' -d 'how the result is printed'
complete -c robochart-verify -n '__robochart_verify_is "validate"' -l format -x -a 'text json sarif' -d 'how findings are printed'
complete -c robochart-verify -n '__robochart_verify_is "cspm"' -l format -x -a 'text plain json framed_json junit' -d 'how the result is printed; plain, json and framed_json as by FDR\'s refines'
complete -c robochart-verify -n '__robochart_verify_is "prism"' -l format -x -a 'text json csv' -d 'how the result is printed'
complete -c robochart-verify -n '__robochart_verify_is "verify" "check" "conform"' -l html -r -F -d 'also write the report as one page with diagrams, on which counterexamples are stepped through'
complete -c robochart-verify -n '__robochart_verify_is "step"' -l html -r -F -d 'instead of the terminal: write one page with what can be reached, on which one steps in a browser'
complete -c robochart-verify -n '__robochart_verify_is "simulate"' -l html -r -F -d 'also write the run as one page: the trials to play through, each robot\'s active states, plots over time'
complete -c robochart-verify -n '__robochart_verify_is "verify" "validate" "check" "emit csp" "emit cpp" "emit prism" "emit monitor" "emit tests" "conform" "cspm" "prism" "step" "draw" "simulate" "format" "explain"' -l color -x -a 'auto always never' -d 'colours of the text; auto: on a terminal, unless NO_COLOR is set'
complete -c robochart-verify -n '__robochart_verify_is "verify" "check" "emit csp" "emit cpp" "emit prism" "emit monitor" "emit tests" "conform" "cspm" "simulate"' -s q -l quiet -d 'print only what is wrong and the closing line'
complete -c robochart-verify -n '__robochart_verify_is "prism"' -s q -l quiet -d 'print the answers, not the sizes'
complete -c robochart-verify -n '__robochart_verify_is "validate"' -s q -l quiet -d 'print only what is wrong'
complete -c robochart-verify -n '__robochart_verify_is "draw"' -s q -l quiet -d 'do not list the files written'
complete -c robochart-verify -n '__robochart_verify_is "format"' -s q -l quiet -d 'do not list the files changed'
complete -c robochart-verify -n '__robochart_verify_is "verify" "check" "conform"' -l trace -d 'also print raw event traces of counterexamples'
complete -c robochart-verify -n '__robochart_verify_is "cspm"' -s b -l brief -d 'verdicts without counterexamples'
complete -c robochart-verify -n '__robochart_verify_is "cspm"' -l reveal-taus -d 'show hidden events by their names'
complete -c robochart-verify -n '__robochart_verify_is "cspm"' -l split -d 'show what every part of the process did, also if there are many'
complete -c robochart-verify -n '__robochart_verify_is "cspm"' -l export -x -a 'aut dot csp' -d 'write all states of a process, any expression of the script, and stop'
complete -c robochart-verify -n '__robochart_verify_is "prism"' -l export -x -a 'tra sta lab dot' -d 'write the transitions, states or labels, or a graph, instead of answers'
complete -c robochart-verify -n '__robochart_verify_is "verify" "check" "emit csp" "emit cpp" "emit prism" "emit monitor" "emit tests" "conform" "cspm" "simulate"' -l progress -x -a 'auto json never' -d 'how far the run has come, on standard error; auto: a line on a terminal, else one each half minute'
complete -c robochart-verify -n '__robochart_verify_is "help"' -l generate -x -a 'man bash zsh fish' -d 'write the man page, or the completion for a shell'
complete -c robochart-verify -n '__robochart_verify_is "verify" "validate" "check" "emit csp" "emit cpp" "emit prism" "emit monitor" "emit tests" "conform" "cspm" "prism" "step" "draw" "simulate" "format"' -l memory -x -d 'memory bound of the program and its child processes, e.g. 4GiB; at most 3/4 of the machine\'s by default'
complete -c robochart-verify -n '__robochart_verify_is "verify" "validate" "check" "emit csp" "emit cpp" "emit prism" "emit monitor" "emit tests" "conform" "cspm" "prism" "step" "draw" "simulate" "format"' -l timeout -x -d 'time bound of the whole run in seconds; 0 for none'
complete -c robochart-verify -n '__robochart_verify_is "verify" "check" "emit csp" "emit cpp" "emit prism" "emit monitor" "emit tests" "conform" "cspm"' -l threads -x -d 'threads of a check at most, used where its state space is wide; 0 for one for each core'
complete -c robochart-verify -n '__robochart_verify_is "simulate"' -l threads -x -d 'parallel trials at most; 0 for one for each core'
complete -c robochart-verify -n '__robochart_verify_is "verify" "check" "cspm"' -l reduction -d 'leave out states that confluent hidden steps lead on from'
complete -c robochart-verify -n '__robochart_verify_is "prism"' -l max-states -x -d 'bound on states of the model'
complete -c robochart-verify -n '__robochart_verify_is "verify" "check" "emit csp" "emit cpp" "emit prism" "emit monitor" "emit tests" "conform" "cspm"' -l max-states -x -d 'bound on states of a check'
complete -c robochart-verify -n '__robochart_verify_is "verify" "check" "emit csp" "emit cpp" "emit prism" "emit monitor" "emit tests" "conform" "cspm" "simulate"' -l no-cache -d 'work out everything anew, and keep nothing for later runs'
complete -c robochart-verify -n '__robochart_verify_is "lsp"' -l stdio -d 'accepted because editors\' libraries pass it; standard input and output are always used'
complete -c robochart-verify -n '__robochart_verify_is "verify" "init" "validate" "check" "emit csp" "emit cpp" "emit prism" "emit monitor" "emit tests" "conform" "cspm" "prism" "step" "draw" "simulate" "format" "explain" "lsp" "help" "version" none' -s h -l help -d 'show the help of the program or of the verb'
complete -c robochart-verify -n '__robochart_verify_is none' -l version -d 'show the version'
