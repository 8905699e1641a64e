// What a command line asks for, as data: the verb, its options, the exit codes. option_table.hpp says how it is
// written.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "checker/prism/sampling/method.hpp"
#include "checker/refine/verdict/check.hpp"
#include "semantics/ir/instantiation.hpp"

namespace robochart::app {

class Run;

/// Exit codes, documented in `--help` (docs/cli.md).
enum class Exit : int {
    success = 0,       ///< everything as claimed
    failed = 1,        ///< some assertion fails, some code does not conform, some file is not formatted
    bad_input = 2,     ///< the model or script is wrong, or the output cannot be written
    inconclusive = 3,  ///< a limit was reached, or interrupted
    usage = 4,
    internal = 70,  ///< internal error
};

/// What is to be done; `emit` has one for each thing written.
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
/// Whether assertions are decided.
[[nodiscard]] constexpr bool decides_assertions(Verb verb) {
    return verb == Verb::verify || verb == Verb::check;
}
/// Whether the result has nothing of assertions: files of them with errors are left out then.
[[nodiscard]] constexpr bool leaves_assertions(Verb verb) {
    return verb == Verb::emit_cpp || verb == Verb::emit_monitor || verb == Verb::emit_tests || verb == Verb::conform ||
           verb == Verb::draw || verb == Verb::rules || verb == Verb::simulate || verb == Verb::step ||
           verb == Verb::tune;
}
/// How results are printed.
enum class Format { text, json, sarif, plain, framed_json, junit, csv };
/// Whether progress goes to stderr, and how.
enum class ProgressMode { automatic, json, never };
/// Whether text is coloured.
enum class Color { automatic, always, never };
/// Which semantics are checked.
enum class Times { both, timed, untimed };

/// What `--version` says behind the name.
inline constexpr const char* program_version = "0.1.0";

/// The command line asks for what there is not: exit code 4.
class UsageError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// The command line as data; docs/cli.md explains each option.
struct Options {
    Verb verb = Verb::verify;
    std::vector<std::string> inputs;  ///< models (files or folders), scripts, or a rule code
    std::string out = "out";
    bool out_given = false;
    Format format = Format::text;
    std::map<Format, std::string> files;  ///< that get the answer in other formats too
    Color color = Color::automatic;
    bool quiet = false;
    bool cache = true;           ///< take what earlier runs have worked out, and keep what this one does
    bool fix = false;            ///< validate: apply certain fixes to the files
    std::string html;            ///< the report as a page, to this file; "": none
    bool simulation = false;     ///< init: with a scenario
    bool ros2 = false;           ///< init: with a mapping to messages
    bool show_internal = false;  ///< --trace: raw event traces with the text of a counterexample
    Times times = Times::both;
    std::string swarm;         ///< file of a swarm whose claims are meant instead of the model's; "": none
    std::uint32_t robots = 0;  ///< of the swarm, instead of the file's; 0: as it says
    std::string grid;          ///< of the swarm, WIDTHxHEIGHT; "": as it says
    bool core = false;
    bool sizes = false;                   ///< check: how large the components' processes are
    bool check = false;                   ///< format: write nothing, tell what would change
    bool diff = false;                    ///< format: write nothing, show what would change
    bool assertions = false;              ///< format: standard input is an assertion file
    std::vector<std::string> claims;      ///< only these (claim_selection.hpp); empty: all
    bool typecheck = false;               ///< cspm: names and types only
    bool types = false;                   ///< cspm: print the types of the script's names and stop
    bool brief = false;                   ///< cspm: no counterexamples
    bool reveal_taus = false;             ///< cspm: hidden events by their names
    bool split = false;                   ///< cspm: what each part did, however many they are
    std::vector<std::string> exported;    ///< cspm: format and process to write out; empty: none
    std::string picture = "svg";          ///< draw: the format of diagrams
    std::string theme = "auto";           ///< draw: their colours
    std::vector<std::string> properties;  ///< prism: questions beside those of the files
    bool exact = false;                   ///< prism, probabilistic assertions: fractions
    double epsilon = 1e-6;                ///< the same: relative width of enclosures
    std::string encoding = "csp";         ///< check: the Markov models that probabilistic assertions are decided on
    std::string scheduler;                ///< who resolves the choices; "": any scheduler
    bool as_sleec_tk = false;             ///< rules: in SLEEC-TK's semantics
    bool suggest = false;                 ///< rules: look for `unless` that removes a conflict
    std::string without_limit = "eventually";  ///< rules: what a response without limit means
    std::string exported_space;                ///< prism: what to write out of the state space; "": nothing
    std::optional<prism::Method> sampling;     ///< prism: answer by random paths
    std::string plot;                          ///< prism: file for a picture of the answers; "": none
    ProgressMode progress = ProgressMode::automatic;
    std::string component;  ///< emit cpp, conform: only this one
    std::uint32_t cycle = 1;
    std::string target;                  ///< emit cpp: a project of this kind; "": the classes alone
    std::string mapping;                 ///< emit cpp --target ros2: file that says which messages carry what
    std::string preferences;             ///< emit prism: RoboTool's file with ranges; "": --range, or the usual ones
    std::string strategy = "auto";       ///< emit cpp: how the code finds what an event does
    std::string print;                   ///< phase to print, "" for none
    std::vector<std::string> constants;  ///< NAME=VALUE
    /// NAME=VALUE of a scenario, a swarm or a log: for the constants that no name of `constants` means.
    std::vector<std::string> weaker_constants;
    std::vector<std::string> ranges;   ///< TYPE=LOW..HIGH
    std::vector<std::string> allowed;  ///< codes of warnings not wanted
    std::uint32_t trials = 0;          ///< simulate: instead of the scenario's; 0: as it says
    std::optional<std::uint64_t>
        seed;  ///< simulate: instead of the scenario's; prism: of the paths; tune: of the search
    std::uint64_t tuning_trials = 1000;    ///< tune: budget of the search
    std::string elimination = "friedman";  ///< tune: the test by which candidates leave
    std::string certificate;               ///< tune: the certificate to decide again; "": search
    std::string compare;                   ///< simulate: a table of earlier trials to compare a sweep with
    bool pictures = true;                  ///< simulate: write tables and pictures
    bool monitor = false;                  ///< simulate: a monitor beside every controller
    std::string guarding_rules;            ///< simulate --monitor: these rules instead of the model; "": none
    std::string log;                       ///< simulate: folder for logs of every robot, "" for none
    std::uint64_t walks = 200'000;         ///< conform: cycles of random walks where the whole is too large; 0: none
    std::string relation = "failures-divergences";  ///< conform --model
    bool choices = false;                           ///< emit cpp --choices, conform --all-choices
    std::uint32_t extra_states = 0;                 ///< emit tests: that an implementation may have more than the model
    std::string exported_code;                      ///< conform: file for L(G), .aut, .dot or .csp; "" for none
    std::vector<std::string> traces;  ///< conform: logs (files, folders) to compare with the model instead of code
    bool cycle_given = false;
    std::string generate;            ///< help: the man page, or a completion, by its name; "" for none
    bool deny_warnings = false;      ///< a warning is as bad as an error
    std::uint64_t memory_bytes = 0;  ///< 0: what `default_memory` says
    double timeout_seconds = 0;      ///< of the whole run; 0: none
    double assertion_seconds = 0;    ///< --assertion-timeout: of each claim; 0: none
    /// When the turn of the claim that is decided ends; none: not before the run.
    std::optional<std::chrono::steady_clock::time_point> turn_ends;
    std::function<void(const refine::Progress&)> on_progress;  ///< called with how far a check has come; may be empty
    std::uint64_t max_states = 500'000'000;
    bool reduction = true;                       ///< states that confluent taus lead on from are left out
    unsigned threads = 0;                        ///< 0: one a core
    std::string checkpoint;                      ///< folder for checkpoints; "": none
    std::string resume;                          ///< folder with checkpoints to go on from; "": none
    std::string disk;                            ///< folder for states that memory does not hold; "": all are in memory
    double minutes_between = 10;                 ///< checkpoints
    refine::LevelStrategy* by_levels = nullptr;  ///< of searches by several programs (app/mpi); null: there is one
    std::string identity;  ///< of programs that go on from each other's checkpoints; "": this one has its own
    Run* run = nullptr;    ///< the run that these options are of: its budget, and signals
};

}  // namespace robochart::app
