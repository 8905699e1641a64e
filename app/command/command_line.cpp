#include "app/command/command_line.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>

#include "app/command/rules.hpp"

namespace robochart::app {
namespace {

constexpr const char* version = "robochart-verify 0.1.0";

constexpr const char* footer = R"(
MODEL is a folder (a project: every .rct and .assertions file below it) or a file (with the .rct files of its
folder that it needs); independent projects are processed separately.

Exit status:
   0  everything as claimed: every assertion holds as worded, the code conforms
   1  some assertion fails, some code does not conform, some file is not formatted (format --check),
      a simulation leaves its bands
   2  the input is wrong, there is nothing to check, or the output cannot be written
   3  inconclusive: a limit was reached, or interrupted, and the results so far are printed; or a claim of a kind that
      is not decided here
   4  wrong usage: unknown options, values out of range, unknown names
  70  internal error: please report it)";

struct VerbRow {
    Verb verb;
    const char* name;
    const char* parent;  ///< "" for top-level verbs
    const char* help;
    const char* input;
};
constexpr std::array<VerbRow, 13> verbs{{
    {Verb::verify, "verify", "", "everything: read, check assertions, export CSP, generate C++, conform (the default)",
     "MODEL"},
    {Verb::check, "check", "", "read the model and decide its assertions", "MODEL"},
    {Verb::emit_csp, "csp", "emit", "write the CSP semantics as scripts for FDR", "MODEL"},
    {Verb::emit_cpp, "cpp", "emit", "write the C++ controllers", "MODEL"},
    {Verb::emit_monitor, "monitor", "emit",
     "write monitors: headers that follow a controller and report where it leaves its model", "MODEL"},
    {Verb::emit_tests, "tests", "emit",
     "write finite complete test suites, and GoogleTest that replays them against an implementation", "MODEL"},
    {Verb::conform, "conform", "", "check generated C++ against the semantics, exhaustively", "MODEL"},
    {Verb::cspm, "cspm", "", "decide the assertions of CSPM scripts", "SCRIPT"},
    {Verb::explain, "explain", "", "explain a rule by its code; without one, list all rules", "CODE"},
    {Verb::simulate, "simulate", "",
     "run a scenario's trials with the generated controllers: measures, bands, pictures", "SCENARIO"},
    {Verb::validate, "validate", "", "read the model and report what is wrong with it, nothing else", "MODEL"},
    {Verb::format, "format", "", "write model and assertion files in the standard layout, in place", "FILE"},
    {Verb::lsp, "lsp", "", "serve an editor over standard input and output (Language Server Protocol)", ""},
}};

/// What a number given on the command line may be. One table for all of them: what a parser takes for a number (nan,
/// -1, 1e300) is not yet one that means something.
struct NumberRow {
    const char* option;
    enum class Kind { whole, seconds, size } kind;
    std::uint64_t least, most;
};
constexpr std::uint64_t any_number = std::numeric_limits<std::uint64_t>::max();
constexpr std::array<NumberRow, 10> numbers{{
    {"--memory", NumberRow::Kind::size, 1, std::uint64_t{1} << 62U},
    {"--timeout", NumberRow::Kind::seconds, 0, 1'000'000'000},
    {"--threads", NumberRow::Kind::whole, 0, 64},
    {"--max-states", NumberRow::Kind::whole, 1, any_number},
    {"--assertion", NumberRow::Kind::whole, 1, 1'000'000'000},
    {"--cycle", NumberRow::Kind::whole, 1, 1000},
    {"--walks", NumberRow::Kind::whole, 0, 1'000'000'000'000},
    {"--trials", NumberRow::Kind::whole, 1, 100'000},
    {"--seed", NumberRow::Kind::whole, 0, any_number},
    {"--extra-states", NumberRow::Kind::whole, 0, 8},
}};

bool parse_whole(std::string_view text, std::uint64_t& value) {
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
    return code == std::errc() && end == text.data() + text.size();
}

/// "300M", "4GiB", "1048576": binary units, whatever their spelling.
bool parse_size(std::string_view text, std::uint64_t& bytes) {
    const std::size_t digits = std::min(text.find_first_not_of("0123456789"), text.size());
    std::string unit(text.substr(digits));
    std::transform(unit.begin(), unit.end(), unit.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    unit.erase(0, std::min(unit.find_first_not_of(' '), unit.size()));
    constexpr std::string_view letters = "kmgtpe";
    std::size_t power = 0;
    if (!unit.empty() && unit != "b") {
        const std::size_t letter = letters.find(unit.front());
        const std::string_view rest = std::string_view(unit).substr(1);
        if (letter == std::string_view::npos || (!rest.empty() && rest != "b" && rest != "ib")) return false;
        power = letter + 1;
    }
    if (!parse_whole(text.substr(0, digits), bytes) || bytes > (any_number >> (10 * power))) return false;
    bytes <<= 10 * power;
    return true;
}

std::string wanted_number(const NumberRow& row) {
    if (row.kind == NumberRow::Kind::size) return "a size above 0 is wanted, as 300M or 4GiB";
    const std::string range =
        row.most == any_number ? fmt::format("from {}", row.least) : fmt::format("from {} to {}", row.least, row.most);
    return fmt::format("a {} {} is wanted", row.kind == NumberRow::Kind::seconds ? "number of seconds" : "whole number",
                       range);
}

/// The check of this option's number, by its row; a size becomes its bytes.
CLI::Validator number(std::string_view option) {
    const auto row =
        *std::find_if(numbers.begin(), numbers.end(), [&](const NumberRow& each) { return each.option == option; });
    return CLI::Validator(
        [row](std::string& text) -> std::string {
            std::uint64_t value = 0;
            bool good = false;
            if (row.kind == NumberRow::Kind::seconds) {
                char* end = nullptr;
                const double seconds = std::strtod(text.c_str(), &end);
                const bool plain =
                    text.find_first_not_of("0123456789.eE+-") == std::string::npos;  // no hexadecimals, nan, infinity
                good = plain && !text.empty() && *end == '\0' && std::isfinite(seconds) &&
                       seconds >= static_cast<double>(row.least) && seconds <= static_cast<double>(row.most);
            } else {
                good = (row.kind == NumberRow::Kind::size ? parse_size(text, value) : parse_whole(text, value)) &&
                       value >= row.least && value <= row.most;
            }
            if (good && row.kind == NumberRow::Kind::size) text = std::to_string(value);
            return good ? "" : fmt::format("{}: {}", text, wanted_number(row));
        },
        "");
}

/// A name that is given is not empty: an empty one would stand for all.
const CLI::Validator named(
    [](std::string& text) { return text.empty() ? std::string("the name is empty") : std::string(); }, "");

void add_color(CLI::App& app, Options& o) {
    const std::map<std::string, Color> colors{
        {"auto", Color::automatic}, {"always", Color::always}, {"never", Color::never}};
    app.add_option("--color", o.color, "auto, always or never")
        ->transform(CLI::CheckedTransformer(colors))
        ->option_text("WHEN [auto]");
}

void add_limits(CLI::App& app, Options& o) {
    app.add_option(
           "--memory", o.memory_bytes,
           "memory bound of the program and its child processes, e.g. 4GiB; at most 3/4 of the machine's by default")
        ->transform(number("--memory"))
        ->option_text("SIZE [16GiB]");
    app.add_option("--timeout", o.timeout_seconds, "time bound of the whole run in seconds; 0 for none")
        ->check(number("--timeout"))
        ->option_text("SECONDS [0]");
}

void add_validate(CLI::App& app, Options& o) {
    const std::map<std::string, Format> formats{
        {"text", Format::text}, {"json", Format::json}, {"sarif", Format::sarif}};
    add_color(app, o);
    app.add_option("--format", o.format, "text, json or sarif")
        ->transform(CLI::CheckedTransformer(formats))
        ->option_text("FORMAT [text]");
    app.add_flag("--fix", o.fix, "apply certain fixes to the files, then report the remaining findings");
    app.add_flag("-q,--quiet", o.quiet, "print only what is wrong");
    add_limits(app, o);
}

void add_format_choice(CLI::App& app, Options& o, bool script) {
    std::map<std::string, Format> formats{{"text", Format::text}, {"json", Format::json}};
    if (script) {
        formats["plain"] = Format::plain;
        formats["framed_json"] = Format::framed_json;
    }
    app.add_option("--format", o.format, script ? "text; as FDR's refines: plain, json or framed_json" : "text or json")
        ->transform(CLI::CheckedTransformer(formats))
        ->option_text(script ? "FORMAT [text] {text,plain,json,framed_json}" : "FORMAT [text]");
}

void add_progress(CLI::App& app, Options& o) {
    const std::map<std::string, ProgressMode> modes{
        {"auto", ProgressMode::automatic}, {"json", ProgressMode::json}, {"never", ProgressMode::never}};
    app.add_option("--progress", o.progress, "auto (a line on a terminal), json or never")
        ->transform(CLI::CheckedTransformer(modes))
        ->option_text("HOW [auto] {auto,json,never}");
}

void add_common(CLI::App& app, Options& o) {
    add_color(app, o);
    app.add_flag("-q,--quiet", o.quiet, "print only what is wrong and the closing line");
    add_progress(app, o);
    add_limits(app, o);
    app.add_flag_callback(
        "--no-cache", [&o] { o.cache = false; }, "work out everything anew, and keep nothing for later runs");
    app.add_option("--threads", o.threads,
                   "threads of a check at most, used where its state space is wide; 0 for one for each core")
        ->check(number("--threads"))
        ->option_text("N [0]");
    app.add_option("--max-states", o.max_states, "bound on states of a check")
        ->check(number("--max-states"))
        ->option_text("N [500000000]");
}

/// The code of a rule that warns, as the tables write it.
std::string warning_code(std::string& code) {
    for (const diagnostics::Rule* rule : find_rules(code))
        if (rule->severity == diagnostics::Severity::warning) {
            code = std::string(rule->code);
            return "";
        }
    return fmt::format("{} is no code of a warning (robochart-verify explain lists them)", code);
}

void add_warnings(CLI::App& app, Options& o) {
    app.add_option("--allow", o.allowed, "leave out warnings of this code; may be repeated")
        ->allow_extra_args(false)
        ->transform(CLI::Validator(warning_code, "CODE"))
        ->option_text("CODE ...");
    app.add_flag("--deny-warnings", o.deny_warnings, "treat a model with warnings as wrong");
}

void add_model(CLI::App& app, Options& o) {
    add_warnings(app, o);
    app.add_option("--const", o.constants, "value of a constant the model leaves open")->option_text("NAME=VALUE ...");
    app.add_option("--range", o.ranges,
                   "carrier of nat, int or real; lengths of Seq, times of clock, elements of given")
        ->option_text("TYPE=LOW..HIGH ...");
    app.add_option("--print", o.print, "print a phase and stop")
        ->check(CLI::IsMember({"ast", "model", "ir", "script", "timed-script"}))
        ->option_text("PHASE {ast,model,ir,script,timed-script}");
}

void add_checking(CLI::App& app, Options& o) {
    app.add_option("--assertion", o.assertion, "only the assertion of this name")->check(named)->option_text("NAME");
    app.add_flag("--trace", o.show_internal, "also print raw event traces of counterexamples");
}

void add_script(CLI::App& app, Options& o) {
    app.add_option("--assertion", o.assertion, "only this assertion of each script, counted from 1")
        ->check(number("--assertion"))
        ->option_text("N");
    app.add_flag("--typecheck", o.typecheck, "check names and types and stop");
    app.add_flag("--types", o.types, "print the type of every name and stop");
    app.add_flag("-b,--brief", o.brief, "verdicts without counterexamples");
    app.add_flag("--reveal-taus", o.reveal_taus, "show hidden events by their names");
    app.add_flag("--split", o.split, "show what every part of the process did, also if there are many");
    app.add_option("--export", o.exported, "write all states of a process, any expression of the script, and stop")
        ->expected(2)
        ->option_text("FORMAT PROCESS {aut,dot,csp}");
}

void add_times(CLI::App& app, Options& o) {
    auto* timed = app.add_flag_callback(
        "--timed", [&o] { o.times = Times::timed; }, "only the timed semantics");
    app.add_flag_callback(
           "--untimed", [&o] { o.times = Times::untimed; }, "only the untimed semantics")
        ->excludes(timed);
    app.add_flag("--core", o.core, "also check the generated core assertions of every component");
    app.add_flag("--sizes", o.sizes, "print the number of states and transitions of every component");
}

void add_code(CLI::App& app, Options& o) {
    app.add_option("--component", o.component, "only this module, controller or machine")
        ->check(named)
        ->option_text("NAME");
    app.add_option_function<std::uint32_t>(
           "--cycle",
           [&o](const std::uint32_t& units) {
               o.cycle = units;
               o.cycle_given = true;
           },
           "time units of one control cycle")
        ->check(number("--cycle"))
        ->option_text("N [1]");
}

void add_strategy(CLI::App& app, Options& o) {
    app.add_option("--strategy", o.strategy,
                   "how generated code selects what an event does: by a switch over states and events, or by a table; "
                   "auto: a table from five states on")
        ->check(CLI::IsMember({"auto", "switch", "table"}))
        ->option_text("STRATEGY {auto,switch,table} [auto]");
}

void add_target(CLI::App& app, Options& o) {
    app.add_flag("--choices", o.choices,
                 "code that asks its platform where the model leaves a choice (`pick`), instead of taking the first");
    app.add_option("--target", o.target, "a complete project, below DIR/TARGET/COMPONENT")
        ->check(CLI::IsMember({"library", "main", "ros2", "enki", "argos"}))
        ->option_text("TARGET {library,main,ros2,enki,argos}");
}

void add_out(CLI::App& app, Options& o) {
    app.add_option_function<std::string>(
           "--out",
           [&o](const std::string& dir) {
               o.out = dir;
               o.out_given = true;
           },
           "folder for the files written")
        ->check(named)
        ->option_text("DIR [out]");
}

void add_conform(CLI::App& app, Options& o) {
    app.add_option("--traces", o.traces,
                   "compare logs of runs with the model (docs/traces.md), and no generated code; files, or folders "
                   "with .trace files")
        ->allow_extra_args(false)
        ->option_text("FILE ...");
    app.add_option("--model", o.relation,
                   "what is decided: refinement in failures-divergences, or in tick-tock, which records refusals "
                   "before each tock")
        ->check(CLI::IsMember({"failures-divergences", "tick-tock"}))
        ->option_text("MODEL {failures-divergences,tick-tock}");
    app.add_flag("--all-choices", o.choices,
                 "where the model leaves a choice, explore every alternative, not only the first");
    app.add_option("--walks", o.walks, "cycles of guided random walks where the state space is too large; 0 for none")
        ->check(number("--walks"))
        ->option_text("N [200000]");
    app.add_option(
           "--export", o.exported_code,
           "write all states of the code to this file, for other tools (.aut, .dot) or with the model for FDR (.csp)")
        ->check(named)
        ->option_text("FILE");
}

void add_simulate(CLI::App& app, Options& o) {
    add_format_choice(app, o, false);
    add_color(app, o);
    add_progress(app, o);
    app.add_flag("-q,--quiet", o.quiet, "print only what is wrong and the closing line");
    app.add_option("--trials", o.trials, "number of trials, instead of the scenario's")
        ->check(number("--trials"))
        ->option_text("N");
    app.add_option("--seed", o.seed, "seed of the first trial, instead of the scenario's")
        ->check(number("--seed"))
        ->option_text("N");
    app.add_option("--threads", o.threads, "parallel trials at most; 0 for one for each core")
        ->check(number("--threads"))
        ->option_text("N [0]");
    add_limits(app, o);
    app.add_flag_callback(
        "--no-pictures", [&o] { o.pictures = false; }, "write no tables and pictures");
    app.add_flag("--monitor", o.monitor, "stop a trial where a robot does what its model does not allow");
    app.add_option("--log", o.log, "write what every robot read and did in every cycle, for `conform --traces`")
        ->check(named)
        ->option_text("DIR");
    app.add_option("--const", o.constants, "value of a constant the model leaves open")->option_text("NAME=VALUE ...");
    add_warnings(app, o);
    add_out(app, o);
}

void add_format(CLI::App& app, Options& o) {
    add_color(app, o);
    app.add_flag("-q,--quiet", o.quiet, "do not list the files changed");
    app.add_flag("--check", o.check, "write nothing; list the files that would change, exit 1 if there are any");
    app.add_flag("--diff", o.diff, "write nothing; show what would change");
    app.add_flag("--assertions", o.assertions, "read standard input (-) as an assertion file");
    add_limits(app, o);
}

void add_options(CLI::App& app, const VerbRow& row, Options& o) {
    if (row.verb == Verb::lsp) {
        app.add_flag_callback(
            "--stdio", [] {}, "accepted because editors' libraries pass it; standard input and output are always used");
        return;
    }
    auto* inputs = app.add_option("inputs", o.inputs, "")->option_text(fmt::format("{}...", row.input));
    if (row.verb == Verb::explain) return add_color(app, o);
    inputs->required();
    if (row.verb == Verb::validate) return add_validate(app, o);
    if (row.verb == Verb::format) return add_format(app, o);
    if (row.verb == Verb::simulate) return add_simulate(app, o);
    add_format_choice(app, o, row.verb == Verb::cspm);
    add_common(app, o);
    if (row.verb == Verb::cspm) return add_script(app, o);
    add_model(app, o);
    if (row.verb == Verb::verify || row.verb == Verb::check || row.verb == Verb::emit_csp) add_times(app, o);
    if (row.verb == Verb::verify || row.verb == Verb::check || row.verb == Verb::conform) add_checking(app, o);
    if (row.verb == Verb::verify || row.verb == Verb::emit_cpp || row.verb == Verb::emit_monitor ||
        row.verb == Verb::emit_tests || row.verb == Verb::conform)
        add_code(app, o);
    if (row.verb == Verb::emit_tests)
        app.add_option("--extra-states", o.extra_states,
                       "states over control cycles that an implementation may have more than the model")
            ->check(number("--extra-states"))
            ->option_text("M [0]");
    if (row.verb == Verb::conform) add_conform(app, o);
    if (row.verb == Verb::emit_cpp) add_target(app, o);
    if (row.verb == Verb::emit_cpp) add_strategy(app, o);
    add_out(app, o);
}

/// `robochart-verify MODEL` is `robochart-verify verify MODEL`: the first word decides.
bool names_a_verb(const std::string& word) {
    if (word == "emit" || word == "-h" || word == "--help" || word == "--version") return true;
    return std::any_of(verbs.begin(), verbs.end(),
                       [&](const VerbRow& row) { return row.parent[0] == '\0' && word == row.name; });
}

Parsed finish(CLI::App& app, const CLI::Error& error) {
    Parsed parsed;
    if (dynamic_cast<const CLI::CallForVersion*>(&error) != nullptr) {
        parsed.message = std::string(version) + "\n";
    } else if (error.get_exit_code() == 0) {
        const CLI::App* shown = &app;
        while (!shown->get_subcommands().empty()) shown = shown->get_subcommands().front();
        parsed.message = shown->help();
    } else {
        parsed.exit = Exit::usage;
        parsed.message = fmt::format("robochart-verify: {}\ntry: robochart-verify --help\n", error.what());
    }
    return parsed;
}

bool parse_number(std::string_view text, std::int64_t& value) {
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
    return code == std::errc() && end == text.data() + text.size();
}

}  // namespace

Parsed parse_command_line(int argc, const char* const* argv) {
    Options o;
    CLI::App app{"Verifies RoboChart models: semantics, assertions, C++ controllers, conformance.", "robochart-verify"};
    app.footer(footer);
    app.set_version_flag("--version", version);
    app.require_subcommand(1);
    auto* emit = app.add_subcommand("emit", "write files, nothing else");
    emit->require_subcommand(1);
    for (const VerbRow& row : verbs) {
        CLI::App& parent = row.parent[0] == '\0' ? app : *emit;
        auto* sub = parent.add_subcommand(row.name, row.help);
        sub->footer(footer);
        add_options(*sub, row, o);
        sub->callback([&o, &row] { o.verb = row.verb; });
    }
    std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
    if (!words.empty() && !names_a_verb(words.front())) words.insert(words.begin(), "verify");
    std::reverse(words.begin(), words.end());
    try {
        app.parse(words);
    } catch (const CLI::Error& error) {
        return finish(app, error);
    }
    return Parsed{o, Exit::success, ""};
}

ir::InstantiationOptions instantiation_options(const Options& o, std::string& error) {
    ir::InstantiationOptions result;
    for (const std::string& text : o.constants) {
        const auto equals = text.find('=');
        if (equals == std::string::npos || equals == 0)
            error = fmt::format("--const {}: expected NAME=VALUE", text);
        else
            result.constants[text.substr(0, equals)] = text.substr(equals + 1);
    }
    for (const std::string& text : o.ranges) {
        const auto equals = text.find('=');
        const auto dots = text.find("..");
        std::int64_t low = 0;
        std::int64_t high = 0;
        const std::string_view view(text);
        const bool good = equals != std::string::npos && dots != std::string::npos && dots > equals &&
                          parse_number(view.substr(equals + 1, dots - equals - 1), low) &&
                          parse_number(view.substr(dots + 2), high);
        if (!good)
            error = fmt::format("--range {}: expected TYPE=LOW..HIGH", text);
        else if (low > high)
            error = fmt::format("--range {}: the range is empty", text);
        else
            result.ranges[text.substr(0, equals)] = {low, high};
    }
    return result;
}

}  // namespace robochart::app
