// SPDX-License-Identifier: Apache-2.0
// Defines the command line as data: the verb, its options, the exit codes. option_table.hpp defines the syntax.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "checker/refine/verdict/check.hpp"
#include "claims/sleec/obligations/obligation.hpp"
#include "conformance/check/result.hpp"
#include "cpp_emit/plan/options.hpp"
#include "driver/settings/search_context.hpp"
#include "driver/settings/settings.hpp"
#include "driver/settings/usage_error.hpp"
#include "prism/sampling/method.hpp"
#include "semantics/ir/instantiation.hpp"
#include "simulation/trial/log_format.hpp"
#include "simulation/tuning/race.hpp"

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

/// The verb. Each word after `emit` is a separate verb.
enum class Verb {
    verify,
    check,
    emit_csp,
    emit_cpp,
    emit_monitor,
    emit_prism,
    emit_tests,
    emit_rst,
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
/// Returns how the verb uses the claims of a model.
[[nodiscard]] driver::ClaimUse claim_use(Verb);
/// True for verbs that decide assertions.
[[nodiscard]] constexpr bool decides_assertions(Verb verb) {
    return verb == Verb::verify || verb == Verb::check;
}
/// The output format of results.
enum class Format { text, json, sarif, plain, framed_json, junit, csv };
/// How progress is written to stderr.
enum class ProgressMode { automatic, json, never };
/// When text is coloured.
enum class Color { automatic, always, never };
/// The version that `--version` prints.
inline constexpr const char* program_version = "0.1.0";

/// Thrown if the command line names something that does not exist. The exit code is 4.
using driver::UsageError;

/// The phase whose result is printed.
enum class Phase { none, ast, model, ir, script, timed_script };

/// The destinations and formats of results.
struct OutputOptions {
    std::string folder = "out";  ///< folder for written files
    bool folder_given = false;
    Format format = Format::text;
    std::map<Format, std::string> files;  ///< files that receive the answer, by format
    Color color = Color::automatic;
    bool quiet = false;
    ProgressMode progress = ProgressMode::automatic;
    std::string html;            ///< file for the report as an HTML page; "": none
    bool provenance = false;     ///< appends the record of the run to text reports
    bool show_internal = false;  ///< --trace: shows raw event traces with a counterexample
    Phase phase = Phase::none;   ///< phase to print instead of results
};

/// Options of `init`: additional files of the new project.
struct InitOptions {
    bool simulation = false;  ///< a scenario
    bool ros2 = false;        ///< a mapping of events to ROS messages
};

/// Options of `format`, which replace the change of the files by another output.
struct FormatOptions {
    bool check = false;       ///< reports files that would change
    bool diff = false;        ///< shows the changes
    bool assertions = false;  ///< standard input is an assertion file
};

/// The format of an exported process.
enum class GraphFormat { aut, dot, csp };

/// Options of `cspm`.
struct ScriptOptions {
    bool typecheck = false;               ///< checks only names and types
    bool types = false;                   ///< prints only the types of the script's names
    bool brief = false;                   ///< no counterexamples
    bool reveal_taus = false;             ///< shows hidden events with their names
    bool split = false;                   ///< shows the behaviour of every part, even if there are many
    std::optional<GraphFormat> exported;  ///< format in which a process is exported; no value: no export
    std::string exported_process;
};

/// The format of diagrams.
enum class PictureFormat { svg, png, pdf, mermaid, dot };
/// The colours of diagrams. `automatic` selects the theme of the reader's system.
enum class Theme { automatic, light, dark };

/// Options of `draw`.
struct DrawOptions {
    PictureFormat picture = PictureFormat::svg;
    Theme theme = Theme::automatic;
};

/// The part of a state space, or the result for one property, that `prism` exports.
enum class SpaceExport { none, transitions, states, labels, graph, strategy, counterexample };

/// Options of `prism`.
struct PrismOptions {
    std::vector<std::string> properties;  ///< additional properties
    SpaceExport exported = SpaceExport::none;
    std::optional<prism::Method> sampling;  ///< the method of statistical model checking; no value: exact answers
    std::string plot;                       ///< file for a plot of the answers; "": none
};

/// Options of `rules`.
struct RuleOptions {
    bool as_sleec_tk = false;  ///< analyses the rules in SLEEC-TK's semantics
    bool suggest = false;      ///< searches for an `unless` that removes a conflict
    sleec::WithoutLimit without_limit = sleec::WithoutLimit::eventually;
};

/// Options for generated code, of `emit cpp`, `emit monitor`, `emit tests` and `conform`.
struct CodeOptions {
    std::uint32_t cycle = 1;  ///< time units of one cycle
    bool cycle_given = false;
    cpp_emit::Target target = cpp_emit::Target::sources;          ///< the classes alone, or a kind of project
    std::string mapping;                                          ///< --target ros2: file that assigns messages
    cpp_emit::PackageFacts package;                               ///< --target ros2
    bool package_given = false;                                   ///< true if an option sets a member of `package`
    bool mapping_draft = false;                                   ///< --target ros2: writes only a draft of a mapping
    bool model_names = false;                                     ///< --target ros2: keeps names, without snake_case
    cpp_emit::Dispatch dispatch = cpp_emit::Dispatch::timer;      ///< --target ros2: when a cycle begins
    cpp_emit::Strategy strategy = cpp_emit::Strategy::automatic;  ///< how the code finds the effect of an event
    std::map<std::string, std::size_t> capacities;                ///< capacities of lists, by event or variable
    bool choices = false;                                         ///< emit cpp --choices, conform --all-choices
};

/// Options of `conform` and `emit tests`.
struct ConformOptions {
    conformance::Relation relation = conformance::Relation::failures_divergences;
    std::uint64_t walks = 200'000;    ///< cycles of random walks if there are too many states; 0: no walks
    std::string exported_code;        ///< file for L(G), .aut, .dot or .csp; "": none
    std::vector<std::string> traces;  ///< logs (files, folders) to check instead of code
    std::uint32_t extra_states = 0;   ///< emit tests: how many more states an implementation may have
};

/// Options of `simulate`.
struct SimulateOptions {
    std::uint32_t trials = 0;           ///< overrides the scenario unless 0
    std::optional<std::uint64_t> seed;  ///< overrides the scenario
    std::string compare;                ///< table of earlier trials to compare a sweep with
    bool pictures = true;               ///< writes tables and pictures
    bool monitor = false;               ///< runs a monitor with every controller
    std::string guarding_rules;         ///< --monitor: rules that replace the model; "": none
    std::string log;                    ///< folder for a log of every robot; "": none
    simulation::LogFormat log_format = simulation::LogFormat::text;
};

/// Options of `tune`.
struct TuneOptions {
    std::uint64_t trials = 1000;  ///< budget of the search
    std::uint64_t seed = 1;       ///< seed of the search
    simulation::Elimination elimination = simulation::Elimination::friedman;
    std::string certificate;  ///< certificate to verify; "": searches for constants instead
};

/// Options of searches that store their states in files.
struct StorageOptions {
    std::string checkpoint;       ///< folder for checkpoints; "": none
    std::string resume;           ///< folder with checkpoints to resume from; "": none
    std::string disk;             ///< folder for states beyond the memory limit; "": only memory is used
    double minutes_between = 10;  ///< minutes between checkpoints
};

/// What `help` prints instead of a help text: the man page, or a completion.
enum class Generated { none, man, bash, zsh, fish };

/// The parsed command line: the settings for reading and checking a model, and the options of the verbs.
/// `robochart-verify help VERB` explains each option.
struct Options : driver::Settings {
    Verb verb = Verb::verify;
    OutputOptions output;
    StorageOptions storage;
    InitOptions init;
    FormatOptions formatting;
    ScriptOptions script;
    DrawOptions draw;
    PrismOptions prism;
    RuleOptions rules;
    CodeOptions code;
    ConformOptions conform;
    SimulateOptions simulate;
    TuneOptions tune;
    bool fix = false;                         ///< validate: apply certain fixes to the files
    Generated generate = Generated::none;     ///< help: the kind of output
    bool cache = true;                        ///< use results of earlier runs, and store new ones
    std::optional<std::uint64_t> given_seed;  ///< value of --seed, for the record of the run
    Run* run = nullptr;                       ///< the run of these options, with its budget and signals
};

/// Sets the verb and the use of claims (`claim_use`).
void set_verb(Options&, Verb);

}  // namespace robochart::app
