// SPDX-License-Identifier: Apache-2.0
// The command line as data: the verb, its options, the exit codes. option_table.hpp defines the syntax.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "checker/refine/verdict/check.hpp"
#include "prism/sampling/method.hpp"
#include "semantics/ir/instantiation.hpp"

namespace robochart::app {

class Run;

/// Exit codes, documented in `--help` (docs/cli.md).
enum class Exit : int {
    success = 0,       ///< all claims are true
    failed = 1,        ///< an assertion fails, code does not conform, or a file is not formatted
    bad_input = 2,     ///< the model or script is wrong, or the output cannot be written
    inconclusive = 3,  ///< a limit was reached, or the run was interrupted
    usage = 4,
    internal = 70,  ///< internal error
};

/// The verb; `emit` has one for each kind of output.
enum class Verb {
    verify,
    check,
    emit_csp,
    emit_cpp,
    emit_monitor,
    emit_prism,
    emit_tests,
    conform,
    cspm,
    draw,
    explain,
    format,
    init,
    lsp,
    prism,
    rules,
    simulate,
    step,
    tune,
    validate,
    help,
    version
};
/// True for verbs that decide assertions.
[[nodiscard]] constexpr bool decides_assertions(Verb verb) {
    return verb == Verb::verify || verb == Verb::check;
}
/// True if the result does not contain assertions, so that assertion files with errors are ignored.
[[nodiscard]] constexpr bool leaves_assertions(Verb verb) {
    return verb == Verb::emit_cpp || verb == Verb::emit_monitor || verb == Verb::emit_tests || verb == Verb::conform ||
           verb == Verb::draw || verb == Verb::rules || verb == Verb::simulate || verb == Verb::step ||
           verb == Verb::tune;
}
/// The output format of results.
enum class Format { text, json, sarif, plain, framed_json, junit, csv };
/// Whether and how progress is written to stderr.
enum class ProgressMode { automatic, json, never };
/// Whether text is coloured.
enum class Color { automatic, always, never };
/// The semantics that are checked.
enum class Times { both, timed, untimed };

/// The version that `--version` prints.
inline constexpr const char* program_version = "0.1.0";

/// The command line names something that does not exist: exit code 4.
class UsageError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// The command line as data; `robochart-verify help VERB` explains each option.
struct Options {
    Verb verb = Verb::verify;
    std::vector<std::string> inputs;  ///< models (files or folders), scripts, or rule codes
    std::string out = "out";
    bool out_given = false;
    Format format = Format::text;
    std::map<Format, std::string> files;  ///< files that receive the answer, by format
    Color color = Color::automatic;
    bool quiet = false;
    bool cache = true;           ///< use results of earlier runs, and store new ones
    bool fix = false;            ///< validate: apply certain fixes to the files
    std::string html;            ///< file for the report as an HTML page; "": none
    bool simulation = false;     ///< init: also writes a scenario
    bool ros2 = false;           ///< init: also writes a mapping to messages
    bool show_internal = false;  ///< --trace: shows raw event traces with a counterexample
    Times times = Times::both;
    std::string swarm;         ///< file of a swarm whose claims replace the model's; "": none
    std::uint32_t robots = 0;  ///< of the swarm; overrides the file; 0: as in the file
    std::string grid;          ///< of the swarm, WIDTHxHEIGHT; "": as in the file
    bool core = false;
    bool sizes = false;                        ///< check: sizes of the components' processes
    bool check = false;                        ///< format: writes nothing, reports files that would change
    bool diff = false;                         ///< format: writes nothing, shows the changes
    bool assertions = false;                   ///< format: standard input is an assertion file
    std::vector<std::string> claims;           ///< selected claims (claim_selection.hpp); empty: all
    bool typecheck = false;                    ///< cspm: checks only names and types
    bool types = false;                        ///< cspm: print the types of the script's names and stop
    bool brief = false;                        ///< cspm: no counterexamples
    bool reveal_taus = false;                  ///< cspm: shows hidden events with their names
    bool split = false;                        ///< cspm: shows the behaviour of every part, however many there are
    std::vector<std::string> exported;         ///< cspm: format and process to export; empty: none
    std::string picture = "svg";               ///< draw: format of diagrams
    std::string theme = "auto";                ///< draw: their colours
    std::vector<std::string> properties;       ///< prism: additional properties
    bool exact = false;                        ///< prism, probabilistic assertions: exact fractions
    double epsilon = 1e-6;                     ///< prism, probabilistic assertions: relative width of intervals
    std::string encoding = "csp";              ///< check: the Markov models used for probabilistic assertions
    std::string scheduler;                     ///< how choices are resolved; "": any scheduler
    bool as_sleec_tk = false;                  ///< rules: in SLEEC-TK's semantics
    bool suggest = false;                      ///< rules: searches for an `unless` that removes a conflict
    std::string without_limit = "eventually";  ///< rules: the meaning of a response without a limit
    std::string exported_space;                ///< prism: the part of the state space to export; "": none
    std::optional<prism::Method> sampling;     ///< prism: answers by random paths
    std::string plot;                          ///< prism: file for a plot of the answers; "": none
    ProgressMode progress = ProgressMode::automatic;
    std::string component;  ///< emit cpp, conform: only this component
    std::uint32_t cycle = 1;
    std::string target;                  ///< emit cpp: kind of project; "": only the classes
    std::string mapping;                 ///< emit cpp --target ros2: file that assigns messages
    std::string preferences;             ///< emit prism: RoboTool's file with ranges; "": --range, or the defaults
    std::string strategy = "auto";       ///< emit cpp: how the code finds the effect of an event
    std::string print;                   ///< phase to print; "": none
    std::vector<std::string> constants;  ///< NAME=VALUE
    /// NAME=VALUE from a scenario, a swarm or a log. These values are used for constants that `constants` does not set.
    std::vector<std::string> weaker_constants;
    std::vector<std::string> ranges;   ///< TYPE=LOW..HIGH
    std::vector<std::string> allowed;  ///< codes of warnings to suppress
    std::uint32_t trials = 0;          ///< simulate: overrides the scenario; 0: as in the scenario
    std::optional<std::uint64_t>
        seed;  ///< simulate: overrides the scenario; prism: for the paths; tune: for the search
    std::uint64_t tuning_trials = 1000;    ///< tune: budget of the search
    std::string elimination = "friedman";  ///< tune: the test that eliminates candidates
    std::string certificate;               ///< tune: certificate to verify; "": search instead
    std::string compare;                   ///< simulate: table of earlier trials to compare a sweep with
    bool pictures = true;                  ///< simulate: writes tables and pictures
    bool monitor = false;                  ///< simulate: runs a monitor with every controller
    std::string guarding_rules;            ///< simulate --monitor: rules that replace the model; "": none
    std::string log;                       ///< simulate: folder for a log of every robot; "": none
    std::uint64_t walks = 200'000;         ///< conform: cycles of random walks if there are too many states; 0: none
    std::string relation = "failures-divergences";  ///< conform --model
    bool choices = false;                           ///< emit cpp --choices, conform --all-choices
    std::uint32_t extra_states = 0;                 ///< emit tests: how many more states an implementation may have
    std::string exported_code;                      ///< conform: file for L(G), .aut, .dot or .csp; "": none
    std::vector<std::string> traces;                ///< conform: logs (files, folders) to check instead of code
    bool cycle_given = false;
    std::string generate;            ///< help: the man page, or a completion, by name; "": none
    bool deny_warnings = false;      ///< treat warnings as errors
    std::uint64_t memory_bytes = 0;  ///< 0: `default_memory`
    double timeout_seconds = 0;      ///< of the whole run; 0: none
    double assertion_seconds = 0;    ///< --assertion-timeout: of each claim; 0: none
    /// The end of the turn of the current claim; no value: the end of the run.
    std::optional<std::chrono::steady_clock::time_point> turn_ends;
    std::function<void(const refine::Progress&)> on_progress;  ///< receives the progress of a check; may be empty
    std::uint64_t max_states = 500'000'000;
    bool reduction = true;                       ///< skips states that only lead on by confluent taus
    unsigned threads = 0;                        ///< 0: one per core
    std::string checkpoint;                      ///< folder for checkpoints; "": none
    std::string resume;                          ///< folder with checkpoints to resume from; "": none
    std::string disk;                            ///< folder for states beyond the memory limit; "": only memory is used
    double minutes_between = 10;                 ///< between checkpoints
    refine::LevelStrategy* by_levels = nullptr;  ///< search by several programs (app/mpi); null: one program
    std::string identity;  ///< identifies programs that can share checkpoints; "": this program's own
    Run* run = nullptr;    ///< the run of these options: its budget and signals
};

}  // namespace robochart::app
