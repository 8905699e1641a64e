// SPDX-License-Identifier: Apache-2.0
// See option_table.hpp.
#include "app/command/option_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <set>
#include <sstream>

#include "app/command/rules.hpp"
#include "base/diagnostics/escape.hpp"
#include "base/diagnostics/spelling.hpp"

namespace robochart::app {

const char* const emit_summary = "write files in one of several formats";

const std::vector<VerbRow>& verb_table() {
    static const std::vector<VerbRow> rows{
        {Verb::verify, "verify", "", "run all steps: check assertions, write CSP, generate C++, conform (the default)",
         "MODEL..."},
        {Verb::init, "init", "", "write a new project: a small robot and claims about it", "[NAME]"},
        {Verb::validate, "validate", "", "report the errors and warnings of a model", "MODEL..."},
        {Verb::check, "check", "", "decide the assertions of a model", "MODEL..."},
        {Verb::emit_csp, "csp", "emit", "write the CSP semantics as scripts for FDR", "MODEL..."},
        {Verb::emit_cpp, "cpp", "emit", "write the C++ controllers", "MODEL..."},
        {Verb::emit_prism, "prism", "emit", "write modules as PRISM models in RoboTool's encoding", "MODEL..."},
        {Verb::emit_monitor, "monitor", "emit",
         "write monitors: headers that report when a controller violates its model, or rules in SLEEC", "MODEL..."},
        {Verb::emit_rst, "rst", "emit", "write components as RoboSim models, with claims that these are equal",
         "MODEL..."},
        {Verb::emit_tests, "tests", "emit",
         "write finite complete test suites, as logs and as GoogleTest for an implementation", "MODEL..."},
        {Verb::conform, "conform", "", "check that generated C++ refines the semantics, for all inputs", "MODEL..."},
        {Verb::cspm, "cspm", "", "decide the assertions of CSPM scripts", "SCRIPT..."},
        {Verb::prism, "prism", "", "decide the properties of a PRISM model (dtmc, mdp)", "MODEL [PROPERTIES...]"},
        {Verb::rules, "rules", "", "find conflicts between rules in SLEEC, and check whether a model obeys them",
         "FILE.sleec [MODEL]"},
        {Verb::step, "step", "", "step by hand through a component, or a process of a CSPM script",
         "MODEL [COMPONENT]"},
        {Verb::draw, "draw", "", "draw diagrams of the components of a model", "MODEL [COMPONENT...]"},
        {Verb::simulate, "simulate", "",
         "simulate a scenario with generated controllers: measures, bands, claims, pictures", "SCENARIO [RULES.sleec]"},
        {Verb::tune, "tune", "",
         "search for the constants with which the claims of a scenario do best, and certify the result", "SCENARIO"},
        {Verb::format, "format", "", "format models, assertions and rules in place", "FILE..."},
        {Verb::explain, "explain", "", "explain a rule by its code; without one, list all rules", "[CODE...]"},
        {Verb::lsp, "lsp", "", "run as a language server on standard input and output", ""},
        {Verb::help, "help", "", "show the help of a verb; write the man page or a shell completion", "[VERB]"},
        {Verb::version, "version", "", "show the version", ""},
    };
    return rows;
}

std::string full_name(const VerbRow& row) {
    return row.parent[0] == '\0' ? row.name : fmt::format("{} {}", row.parent, row.name);
}

const VerbRow* find_verb(std::string_view name) {
    const auto& rows = verb_table();
    const auto row = std::ranges::find_if(rows, [&](const VerbRow& candidate) { return full_name(candidate) == name; });
    return row == rows.end() ? nullptr : &*row;
}

std::vector<std::string> first_words() {
    std::vector<std::string> words;
    for (const VerbRow& row : verb_table()) {
        const std::string word = row.parent[0] == '\0' ? row.name : row.parent;
        if (std::ranges::find(words, word) == words.end()) words.push_back(word);
    }
    return words;
}

std::vector<std::string> emit_targets() {
    std::vector<std::string> words;
    for (const VerbRow& row : verb_table())
        if (row.parent[0] != '\0') words.emplace_back(row.name);
    return words;
}

const std::vector<Group>& option_groups() {
    static const std::vector<Group> all{Group::checking, Group::model,  Group::code,   Group::simulation,
                                        Group::files,    Group::output, Group::limits, Group::general};
    return all;
}

std::string_view group_heading(Group group) {
    constexpr std::array<std::string_view, 8> headings{"Checking", "Model",  "Generated code", "Simulation",
                                                       "Files",    "Output", "Limits",         "General"};
    return headings[static_cast<std::size_t>(group)];
}

namespace {

constexpr std::uint64_t any_number = std::numeric_limits<std::uint64_t>::max();

constexpr Verbs instantiating = verb_bit(Verb::emit_csp) | verb_bit(Verb::emit_cpp) | verb_bit(Verb::emit_monitor) |
                                verb_bit(Verb::emit_tests) | verb_bit(Verb::emit_rst);
constexpr Verbs emitting = instantiating | verb_bit(Verb::emit_prism);
constexpr Verbs checking = verb_bit(Verb::verify) | verb_bit(Verb::check);
constexpr Verbs models = checking | emitting | verb_bit(Verb::conform);
constexpr Verbs coding = verb_bit(Verb::verify) | verb_bit(Verb::emit_cpp) | verb_bit(Verb::emit_monitor) |
                         verb_bit(Verb::emit_tests) | verb_bit(Verb::emit_rst) | verb_bit(Verb::conform);
constexpr Verbs deciding = verb_bit(Verb::check) | verb_bit(Verb::cspm);
constexpr Verbs searching = models | verb_bit(Verb::cspm) | verb_bit(Verb::rules);
constexpr Verbs limited = searching | verb_bit(Verb::prism) | verb_bit(Verb::step) | verb_bit(Verb::validate) |
                          verb_bit(Verb::draw) | verb_bit(Verb::format) | verb_bit(Verb::simulate) |
                          verb_bit(Verb::tune);
constexpr Verbs all_verbs = limited | verb_bit(Verb::explain) | verb_bit(Verb::lsp) | verb_bit(Verb::init) |
                            verb_bit(Verb::help) | verb_bit(Verb::version);

using Kind = Argument::Kind;

/// Returns the index of the word in a list of choices.
std::size_t index_of(const std::string& word, const char* words) {
    const std::vector<std::string> all = choices_of({.choices = words});
    return static_cast<std::size_t>(std::ranges::find(all, word) - all.begin());
}

std::uint64_t to_number(const std::string& word) {
    return std::stoull(word);
}

void take_format(Options& o, const std::string& word) {
    o.output.format = static_cast<Format>(index_of(word, "text,json,sarif,plain,framed_json,junit,csv"));
}

void take_quiet(Options& o, const std::string&) {
    o.output.quiet = true;
}

void take_scheduler(Options& o, const std::string& word) {
    o.probability.scheduler = static_cast<driver::Scheduler>(index_of(word, "any,urgent,uniform"));
}

void take_choices(Options& o, const std::string&) {
    o.code.choices = true;
}

/// Stores the version of a package, which consists of three whole numbers (REP 149).
void take_package_version(Options& o, const std::string& word) {
    std::size_t numbers = 0, digits = 0;
    bool wrong = word.size() > 32;
    for (const char c : word + ".") {
        const bool digit = c >= '0' && c <= '9';
        wrong = wrong || (!digit && (c != '.' || digits == 0));
        if (c == '.') ++numbers;
        digits = digit ? digits + 1 : 0;
    }
    if (wrong || numbers != 3)
        throw UsageError(fmt::format("--package-version {}: expected three numbers, as in 1.2.0",
                                     diagnostics::escape_for_display(word)));
    o.code.package.version = word;
    o.code.package_given = true;
}

bool is_letter_or_digit(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
}

/// A licence as an SPDX expression: identifiers, `AND`, `OR`, `WITH`, brackets.
void take_license(Options& o, const std::string& word) {
    constexpr std::string_view others = "-.+() ";
    const auto fits = [&](char c) { return is_letter_or_digit(c) || others.find(c) != std::string_view::npos; };
    if (word.empty() || word.size() > 200 || !std::ranges::all_of(word, fits))
        throw UsageError(fmt::format("--license {}: expected an SPDX expression, as in Apache-2.0",
                                     diagnostics::escape_for_display(word)));
    o.code.package.license = word;
    o.code.package_given = true;
}

/// Returns whether a text consists of at least one word of these characters, separated by single dots.
bool is_dotted(std::string_view text, std::string_view others) {
    const auto fits = [&](char c) {
        return c == '.' || is_letter_or_digit(c) || others.find(c) != std::string_view::npos;
    };
    return !text.empty() && text.front() != '.' && text.back() != '.' && text.find("..") == std::string_view::npos &&
           std::ranges::all_of(text, fits);
}

/// Returns whether the tools of ROS 2 accept an address. Their package catkin_pkg, with which `colcon` reads
/// package.xml, demands a domain with a dot whose last part has at least two letters.
bool is_address(std::string_view text) {
    const std::size_t at = text.find('@'), dot = text.rfind('.');
    if (at == std::string_view::npos || dot == std::string_view::npos || dot < at) return false;
    const std::string_view end = text.substr(dot + 1);
    const bool letters = std::ranges::none_of(end, [](char c) { return c == '-' || (c >= '0' && c <= '9'); });
    return letters && end.size() >= 2 && is_dotted(text.substr(0, at), "-_+") && is_dotted(text.substr(at + 1), "-");
}

/// Stores a maintainer, given as NAME <EMAIL>.
void take_maintainer(Options& o, const std::string& word) {
    const std::size_t open = word.find(" <");
    const bool named = open != std::string::npos && open > 0 && word.back() == '>' && word.size() <= 200;
    const bool plain = std::ranges::none_of(word, [](char c) { return static_cast<unsigned char>(c) < 0x20; });
    const std::string email = named ? word.substr(open + 2, word.size() - open - 3) : "";
    if (!plain || !is_address(email))
        throw UsageError(fmt::format("--maintainer {}: expected a name and an address, as in 'Ada <ada@example.org>'",
                                     diagnostics::escape_for_display(word)));
    o.code.package.maintainer = word.substr(0, open);
    o.code.package.email = email;
    o.code.package_given = true;
}

/// Stores EVENT=N, the capacity of the lists of an event or variable.
void take_capacity(Options& o, const std::string& word) {
    const std::size_t equals = word.find('=');
    const std::string number = equals == std::string::npos ? "" : word.substr(equals + 1);
    std::size_t capacity = 0;
    const auto [end, code] = std::from_chars(number.data(), number.data() + number.size(), capacity);
    const bool whole = code == std::errc() && end == number.data() + number.size();
    if (!whole || equals == 0 || capacity < 1 || capacity > cpp_emit::greatest_capacity)
        throw UsageError(fmt::format("--capacity {}: expected EVENT=N, with a whole number N from 1 to {}",
                                     diagnostics::escape_for_display(word), cpp_emit::greatest_capacity));
    if (!o.code.capacities.emplace(word.substr(0, equals), capacity).second)
        throw UsageError(
            fmt::format("--capacity {} is given twice", diagnostics::escape_for_display(word.substr(0, equals))));
}

void take_threads(Options& o, const std::string& word) {
    o.limits.threads = static_cast<unsigned>(to_number(word));
}

/// Stores a file that receives the answer in the format, in addition to the output of --format.
template <Format format>
void take_file(Options& o, const std::string& path) {
    for (const auto& [other, taken] : o.output.files)
        if (taken == path) throw UsageError(path + " is given for two output formats");
    o.output.files[format] = path;
}

constexpr Argument answer_file{.kind = Kind::file, .name = "FILE"};

constexpr Argument format_of(const char* choices) {
    return {.kind = Kind::choice, .name = "FORMAT", .usual = "text", .choices = choices};
}

}  // namespace

// clang-format off
const std::vector<OptionRow>& option_table() {
    static const std::vector<OptionRow> rows{
        {"--assertion", Group::checking, checking | verb_bit(Verb::cspm), {.kind = Kind::name, .name = "WHICH", .repeated = true},
         "check only these: a name, a number (from 1), a range (3..5) or a pattern (Safe*); in scripts and swarms the "
         "name is the text of the claim",
         [](Options& o, const std::string& word) { o.claims.names.push_back(word); }},
        {"--timed", Group::checking, checking | verb_bit(Verb::emit_csp), {}, "use only the timed semantics",
         [](Options& o, const std::string&) { o.claims.times = driver::Times::timed; }, "--untimed"},
        {"--untimed", Group::checking, checking | verb_bit(Verb::emit_csp) | verb_bit(Verb::step), {}, "use only the untimed semantics",
         [](Options& o, const std::string&) { o.claims.times = driver::Times::untimed; }},
        {"--core", Group::checking, checking | verb_bit(Verb::emit_csp), {},
         "also check the core properties of every component; the default only if the model has no assertions",
         [](Options& o, const std::string&) { o.claims.core = true; }},
        {"--concrete", Group::checking, checking | verb_bit(Verb::conform), {},
         "decide claims and compare code in the finite instantiation only, as RoboTool does, instead of for all values",
         [](Options& o, const std::string&) { o.claims.concrete = true; }},
        {"--sizes", Group::checking, checking, {},
         "print the number of states and transitions of every component",
         [](Options& o, const std::string&) { o.claims.sizes = true; }},
        {"--swarm", Group::checking, verb_bit(Verb::check) | verb_bit(Verb::emit_csp), {.kind = Kind::file, .name = "FILE"},
         "check the claims of this file (.swarm) about several robots instead of the assertions of the model",
         [](Options& o, const std::string& word) { o.swarm.file = word; }, "--core"},
        {"--robots", Group::checking, verb_bit(Verb::check) | verb_bit(Verb::emit_csp),
         {.kind = Kind::whole, .name = "N", .least = 1, .most = 8},
         "with --swarm: number of robots (overrides the file)",
         [](Options& o, const std::string& word) { o.swarm.robots = static_cast<std::uint32_t>(to_number(word)); }},
        {"--grid", Group::checking, verb_bit(Verb::check) | verb_bit(Verb::emit_csp), {.kind = Kind::text, .name = "WxH"},
         "with --swarm: size of the grid (overrides the file)",
         [](Options& o, const std::string& word) { o.swarm.grid = word; }},
        {"--typecheck", Group::checking, verb_bit(Verb::cspm), {}, "check names and types, then stop",
         [](Options& o, const std::string&) { o.script.typecheck = true; }},
        {"--types", Group::checking, verb_bit(Verb::cspm), {}, "print the type of every name, then stop",
         [](Options& o, const std::string&) { o.script.types = true; }},

        {"--property", Group::checking, verb_bit(Verb::prism), {.kind = Kind::name, .name = "TEXT", .repeated = true},
         "an additional property, for example 'P=? [ F \"done\" ]'",
         [](Options& o, const std::string& word) { o.prism.properties.push_back(word); }},
        {"--encoding", Group::checking, checking,
         {.kind = Kind::choice, .name = "ENCODING", .usual = "csp", .choices = "csp,robotool"},
         "model for probabilistic assertions: decision processes from the timed CSP semantics (csp), or RoboTool's "
         "Markov chains (robotool)",
         [](Options& o, const std::string& word) { o.probability.encoding = word == "robotool" ? driver::Encoding::robotool : driver::Encoding::csp; }},
        {"--scheduler", Group::checking, checking,
         {.kind = Kind::choice, .name = "SCHEDULER", .usual = "any", .choices = "any,urgent,uniform"},
         "how nondeterminism is resolved: any (best and worst case), urgent (internal steps before inputs and time), "
         "uniform (equally likely)",
         take_scheduler},
        {"--exact", Group::checking, checking | verb_bit(Verb::prism), {},
         "compute exact probabilities with fractions (small models only)",
         [](Options& o, const std::string&) { o.probability.exact = true; }},
        {"--epsilon", Group::checking, checking | verb_bit(Verb::prism),
         {.kind = Kind::fraction, .name = "WIDTH", .usual = "0.000001"},
         "maximum width of the interval around a value, relative to the value",
         [](Options& o, const std::string& word) { o.probability.epsilon = std::strtod(word.c_str(), nullptr); }, "--exact"},

        {"--sim", Group::checking, verb_bit(Verb::prism),
         {.kind = Kind::text, .name = "METHOD"},
         "answer by random paths: ci, aci, apmc or sprt, followed by ,samples=N ,width=W ,confidence=ALPHA ,path=STEPS",
         [](Options& o, const std::string& word) {
             try {
                 o.prism.sampling = prism::read_method(word);
             } catch (const prism::BadMethod& error) {
                 throw UsageError(std::string("--sim ") + error.what());
             }
         },
         "--exact"},
        {"--scheduler", Group::checking, verb_bit(Verb::prism),
         {.kind = Kind::choice, .name = "WHO", .choices = "uniform"},
         "how nondeterminism of an mdp is resolved: uniform makes all enabled commands equally likely, as in a dtmc",
         take_scheduler},
        {"--seed", Group::checking, checking | verb_bit(Verb::prism), {.kind = Kind::whole, .name = "N", .usual = "0", .most = any_number},
         "seed of random paths, for --sim, `using sim` and `prob generate path`",
         [](Options& o, const std::string& word) { o.given_seed = o.probability.seed = to_number(word); }},
        {"--without-limit", Group::checking, verb_bit(Verb::rules),
         {.kind = Kind::choice, .name = "READING", .usual = "eventually", .choices = "eventually,now"},
         "when a response without limit is due: eventually, or now (at once, as in LEGOS)",
         [](Options& o, const std::string& word) {
             o.rules.without_limit = word == "now" ? sleec::WithoutLimit::now : sleec::WithoutLimit::eventually;
         }},
        {"--as-sleec-tk", Group::checking, verb_bit(Verb::rules), {},
         "compare pairs of rules in the semantics of SLEEC-TK, including its faults",
         [](Options& o, const std::string&) { o.rules.as_sleec_tk = true; }, "--without-limit"},
        {"--suggest", Group::checking, verb_bit(Verb::rules), {},
         "search for an `unless` that removes each conflict, and check it",
         [](Options& o, const std::string&) { o.rules.suggest = true; }, "--as-sleec-tk"},

        {"--const", Group::model, verb_bit(Verb::prism), {.kind = Kind::text, .name = "NAME=VALUE", .repeated = true},
         "value of an open constant, or values to try: LOW:HIGH, LOW:STEP:HIGH, or a list with commas",
         [](Options& o, const std::string& word) { o.instantiation.constants.push_back(word); }},
        {"--const", Group::model,
         checking | instantiating | verb_bit(Verb::conform) | verb_bit(Verb::rules) | verb_bit(Verb::step) | verb_bit(Verb::simulate),
         {.kind = Kind::text, .name = "NAME=VALUE", .repeated = true},
         "value of a constant",
         [](Options& o, const std::string& word) { o.instantiation.constants.push_back(word); }},
        {"--const", Group::model, verb_bit(Verb::tune), {.kind = Kind::text, .name = "NAME=VALUE", .repeated = true},
         "value of a constant, or values to try: LOW..HIGH, or a list with commas",
         [](Options& o, const std::string& word) { o.instantiation.constants.push_back(word); }},
        {"--range", Group::model, models | verb_bit(Verb::rules) | verb_bit(Verb::step) | verb_bit(Verb::tune), {.kind = Kind::text, .name = "TYPE=LOW..HIGH", .repeated = true},
         "carrier of nat, int or real; lengths of sequences (Seq), times of clocks (clock), elements of given types (given)",
         [](Options& o, const std::string& word) { o.instantiation.ranges.push_back(word); }},
        {"--prefs", Group::model, checking | verb_bit(Verb::emit_prism), {.kind = Kind::file, .name = "FILE"},
         "read RoboTool's preferences (rc2prism.prefs): the ranges of nat, int and real, and the kind of model",
         [](Options& o, const std::string& word) { o.probability.preferences = word; }, "--range"},
        {"--print", Group::model, models,
         {.kind = Kind::choice, .name = "PHASE", .choices = "ast,model,ir,script,timed-script"},
         "print the result of a phase, then stop", [](Options& o, const std::string& word) {
             o.output.phase = static_cast<Phase>(1 + index_of(word, "ast,model,ir,script,timed-script"));
             o.load.split_broken_claims = false;
         }},
        {"--allow", Group::model, models | verb_bit(Verb::prism) | verb_bit(Verb::rules) | verb_bit(Verb::step) | verb_bit(Verb::validate) | verb_bit(Verb::draw) | verb_bit(Verb::simulate) | verb_bit(Verb::tune),
         {.kind = Kind::warning, .name = "CODE", .repeated = true}, "suppress warnings with this code",
         [](Options& o, const std::string& word) { o.load.allowed.push_back(word); }},
        {"--deny-warnings", Group::model, models | verb_bit(Verb::rules) | verb_bit(Verb::step) | verb_bit(Verb::validate) | verb_bit(Verb::draw) | verb_bit(Verb::simulate) | verb_bit(Verb::tune), {},
         "treat a model with warnings as wrong", [](Options& o, const std::string&) { o.load.deny_warnings = true; }},

        {"--component", Group::code, coding | verb_bit(Verb::emit_prism) | verb_bit(Verb::rules), {.kind = Kind::name, .name = "NAME"},
         "process only this module, controller or machine",
         [](Options& o, const std::string& word) { o.load.component = word; }},
        {"--cycle", Group::code, coding,
         {.kind = Kind::whole, .name = "N", .usual = "1", .least = 1, .most = 1000},
         "time units of one control cycle",
         [](Options& o, const std::string& word) {
             o.code.cycle = static_cast<std::uint32_t>(to_number(word));
             o.code.cycle_given = true;
         }},
        {"--target", Group::code, verb_bit(Verb::emit_cpp),
         {.kind = Kind::choice, .name = "TARGET", .choices = "library,main,ros2,enki,argos,python"},
         "write a complete project for this platform to DIR/TARGET/COMPONENT",
         [](Options& o, const std::string& word) {
             o.code.target = static_cast<cpp_emit::Target>(index_of(word, "sources,library,main,ros2,enki,argos,python"));
         }},
        {"--mapping", Group::code, verb_bit(Verb::emit_cpp), {.kind = Kind::file, .name = "FILE"},
         "with --target ros2: the messages and topics of operations, events and variables",
         [](Options& o, const std::string& word) { o.code.mapping = word; }},
        {"--mapping-draft", Group::code, verb_bit(Verb::emit_cpp), {},
         "with --target ros2: write only a mapping to start from, COMPONENT.ros2; an existing one stays as it is",
         [](Options& o, const std::string&) { o.code.mapping_draft = true; }},
        {"--license", Group::code, verb_bit(Verb::emit_cpp), {.kind = Kind::text, .name = "SPDX"},
         "with --target ros2: the licence in package.xml", take_license},
        {"--maintainer", Group::code, verb_bit(Verb::emit_cpp), {.kind = Kind::text, .name = "PERSON"},
         "with --target ros2: the maintainer in package.xml, as 'NAME <EMAIL>'", take_maintainer},
        {"--package-version", Group::code, verb_bit(Verb::emit_cpp),
         {.kind = Kind::text, .name = "X.Y.Z", .usual = "0.1.0"}, "with --target ros2: the version in package.xml",
         take_package_version},
        {"--model-names", Group::code, verb_bit(Verb::emit_cpp), {},
         "with --target ros2: nodes, topics and launch files have the names of the model, not snake_case",
         [](Options& o, const std::string&) { o.code.model_names = true; }},
        {"--dispatch", Group::code, verb_bit(Verb::emit_cpp),
         {.kind = Kind::choice, .name = "WHEN", .usual = "timer", .choices = "timer,immediate"},
         "with --target ros2: when a cycle begins: by the timer, or also when an input arrives, for models without time",
         [](Options& o, const std::string& word) {
             o.code.dispatch = static_cast<cpp_emit::Dispatch>(index_of(word, "timer,immediate"));
         }},
        {"--strategy", Group::code, verb_bit(Verb::emit_cpp),
         {.kind = Kind::choice, .name = "STRATEGY", .usual = "auto", .choices = "auto,switch,table"},
         "how generated code finds the reaction to an event: a switch over states and events, or a table; auto uses a "
         "table from five states on",
         [](Options& o, const std::string& word) {
             o.code.strategy = static_cast<cpp_emit::Strategy>(index_of(word, "auto,switch,table"));
         }},
        {"--capacity", Group::code, verb_bit(Verb::emit_cpp), {.kind = Kind::text, .name = "EVENT=N", .repeated = true},
         "largest number of items in the lists of an event or variable: 1 to 65536 [64; lists of lists 16]",
         take_capacity},
        {"--choices", Group::code, verb_bit(Verb::emit_cpp), {},
         "generate code that asks its platform (`pick`) if the model leaves a choice, instead of taking the first",
         take_choices},
        {"--all-choices", Group::code, verb_bit(Verb::conform), {},
         "explore every alternative of a choice in the model, not only the first", take_choices},
        {"--model", Group::code, verb_bit(Verb::conform),
         {.kind = Kind::choice, .name = "MODEL", .usual = "failures-divergences",
          .choices = "failures-divergences,tick-tock"},
         "semantic model of the refinement; tick-tock records refusals before each tock",
         [](Options& o, const std::string& word) {
             o.conform.relation = static_cast<conformance::Relation>(index_of(word, "failures-divergences,tick-tock"));
         }},
        {"--walks", Group::code, verb_bit(Verb::conform),
         {.kind = Kind::whole, .name = "N", .usual = "200000", .most = 1'000'000'000'000},
         "cycles of guided random walks if the state space is too large; 0 for none",
         [](Options& o, const std::string& word) { o.conform.walks = to_number(word); }},
        {"--export", Group::code, verb_bit(Verb::conform), {.kind = Kind::file, .name = "FILE"},
         "write all states of the code to this file, for other tools (.aut, .dot), or with the model for FDR (.csp)",
         [](Options& o, const std::string& word) { o.conform.exported_code = word; }},
        {"--traces", Group::code, verb_bit(Verb::conform), {.kind = Kind::file, .name = "FILE", .repeated = true},
         "compare logs of runs, instead of generated code, with the model: files, or folders with .trace files",
         [](Options& o, const std::string& word) { o.conform.traces.push_back(word); }},
        {"--extra-states", Group::code, verb_bit(Verb::emit_tests),
         {.kind = Kind::whole, .name = "M", .usual = "0", .most = 8},
         "number of states that an implementation may have in addition to those of the model",
         [](Options& o, const std::string& word) { o.conform.extra_states = static_cast<std::uint32_t>(to_number(word)); }},

        {"--trials", Group::simulation, verb_bit(Verb::simulate),
         {.kind = Kind::whole, .name = "N", .least = 1, .most = 100'000},
         "number of trials (overrides the scenario)",
         [](Options& o, const std::string& word) { o.simulate.trials = static_cast<std::uint32_t>(to_number(word)); }},
        {"--seed", Group::simulation, verb_bit(Verb::simulate), {.kind = Kind::whole, .name = "N", .most = any_number},
         "seed of the first trial (overrides the scenario)",
         [](Options& o, const std::string& word) { o.given_seed = o.simulate.seed = to_number(word); }},
        {"--budget", Group::simulation, verb_bit(Verb::tune),
         {.kind = Kind::whole, .name = "N", .usual = "1000", .least = 1, .most = 100'000'000},
         "maximum number of trials of the search",
         [](Options& o, const std::string& word) { o.tune.trials = to_number(word); }},
        {"--seed", Group::simulation, verb_bit(Verb::tune),
         {.kind = Kind::whole, .name = "N", .usual = "1", .most = 1'000'000'000},
         "seed of the search; claims are decided on the seeds of the scenario",
         [](Options& o, const std::string& word) { o.given_seed = o.tune.seed = to_number(word); }},
        {"--test", Group::simulation, verb_bit(Verb::tune),
         {.kind = Kind::choice, .name = "TEST", .usual = "friedman", .choices = "friedman,t-test"},
         "statistical test that drops worse values from the search",
         [](Options& o, const std::string& word) {
             o.tune.elimination = static_cast<simulation::Elimination>(index_of(word, "friedman,t-test"));
         }},
        {"--verify-certificate", Group::simulation, verb_bit(Verb::tune), {.kind = Kind::file, .name = "FILE"},
         "do not search; decide the contents of this certificate again and compare",
         [](Options& o, const std::string& word) { o.tune.certificate = word; }},
        {"--compare", Group::simulation, verb_bit(Verb::simulate), {.kind = Kind::file, .name = "FILE"},
         "compare the estimates of a sweep with a table of earlier trials, such as its sweep.csv",
         [](Options& o, const std::string& word) { o.simulate.compare = word; }},
        {"--monitor", Group::simulation, verb_bit(Verb::simulate), {},
         "stop a trial if a robot violates its model or, with RULES.sleec, a rule",
         [](Options& o, const std::string&) { o.simulate.monitor = true; }},
        {"--log", Group::simulation, verb_bit(Verb::simulate), {.kind = Kind::folder, .name = "DIR"},
         "write what every robot read and did in every cycle, for `conform --traces`",
         [](Options& o, const std::string& word) { o.simulate.log = word; }},
        {"--log-format", Group::simulation, verb_bit(Verb::simulate),
         {.kind = Kind::choice, .name = "FORMAT", .usual = "text", .choices = "text,mcap"},
         "format of the logs of --log: text, or MCAP, the format of rosbag2's recordings",
         [](Options& o, const std::string& word) {
             o.simulate.log_format = static_cast<simulation::LogFormat>(index_of(word, "text,mcap"));
         }},
        {"--no-pictures", Group::simulation, verb_bit(Verb::simulate), {}, "do not write tables and pictures",
         [](Options& o, const std::string&) { o.simulate.pictures = false; }},

        {"--fix", Group::files, verb_bit(Verb::validate), {},
         "apply the certain fixes to the files, then report the remaining findings",
         [](Options& o, const std::string&) { o.fix = true; }},
        {"--check", Group::files, verb_bit(Verb::format), {},
         "only list the files that would change; exit 1 if there are any",
         [](Options& o, const std::string&) { o.formatting.check = true; }},
        {"--diff", Group::files, verb_bit(Verb::format), {}, "only show the changes",
         [](Options& o, const std::string&) { o.formatting.diff = true; }},
        {"--assertions", Group::files, verb_bit(Verb::format), {}, "read standard input (-) as an assertion file",
         [](Options& o, const std::string&) { o.formatting.assertions = true; }},

        {"--simulation", Group::files, verb_bit(Verb::init), {}, "add a scenario for `simulate`",
         [](Options& o, const std::string&) { o.init.simulation = true; }},
        {"--ros2", Group::files, verb_bit(Verb::init), {}, "add a mapping to ROS 2 messages for `emit cpp --target ros2`",
         [](Options& o, const std::string&) { o.init.ros2 = true; }},

        {"-o,--out", Group::output, models | verb_bit(Verb::simulate) | verb_bit(Verb::tune),
         {.kind = Kind::folder, .name = "DIR", .usual = "out"}, "output folder",
         [](Options& o, const std::string& word) {
             o.output.folder = word;
             o.output.folder_given = true;
         }},
        {"-o,--out", Group::output, verb_bit(Verb::draw), {.kind = Kind::folder, .name = "PATH", .usual = "out/diagrams"},
         "folder for the diagrams; with one COMPONENT, the file for its diagram (without --out, or with -, standard output)",
         [](Options& o, const std::string& word) {
             o.output.folder = word;
             o.output.folder_given = true;
         }},
        {"--format", Group::output, verb_bit(Verb::draw),
         {.kind = Kind::choice, .name = "FORMAT", .usual = "svg", .choices = "svg,png,pdf,mermaid,dot"},
         "format of the diagrams; png and pdf need rsvg-convert",
         [](Options& o, const std::string& word) {
             o.draw.picture = static_cast<PictureFormat>(index_of(word, "svg,png,pdf,mermaid,dot"));
         }},
        {"--theme", Group::output, verb_bit(Verb::draw),
         {.kind = Kind::choice, .name = "THEME", .usual = "auto", .choices = "auto,light,dark"},
         "colours of the diagrams; auto follows the reader's system",
         [](Options& o, const std::string& word) {
             o.draw.theme = static_cast<Theme>(index_of(word, "auto,light,dark"));
         }},
        {"--format", Group::output, emitting | verb_bit(Verb::simulate) | verb_bit(Verb::tune), format_of("text,json"), "output format",
         take_format},
        {"--format", Group::output, checking, format_of("text,json,sarif,junit"), "output format",
         take_format},
        {"--format", Group::output, verb_bit(Verb::conform), format_of("text,json,junit"), "output format",
         take_format},
        {"--format", Group::output, verb_bit(Verb::validate), format_of("text,json,sarif"), "output format",
         take_format},
        {"--format", Group::output, verb_bit(Verb::cspm), format_of("text,plain,json,framed_json,junit"),
         "output format; plain, json and framed_json are those of FDR's refines", take_format},
        {"--format", Group::output, verb_bit(Verb::prism), format_of("text,json,csv"), "output format",
         take_format},
        {"--format", Group::output, verb_bit(Verb::rules) | verb_bit(Verb::version), format_of("text,json"), "output format", take_format},
        {"--json", Group::output, emitting | checking | verb_bit(Verb::conform) | verb_bit(Verb::validate) | verb_bit(Verb::cspm) | verb_bit(Verb::prism) | verb_bit(Verb::rules) | verb_bit(Verb::simulate) | verb_bit(Verb::tune),
         answer_file, "also write the result as --format json prints it", take_file<Format::json>},
        {"--sarif", Group::output, checking | verb_bit(Verb::validate), answer_file,
         "also write the result as --format sarif prints it", take_file<Format::sarif>},
        {"--junit", Group::output, checking | verb_bit(Verb::conform) | verb_bit(Verb::cspm), answer_file,
         "also write the result as --format junit prints it", take_file<Format::junit>},
        {"--html", Group::output, checking | verb_bit(Verb::conform), {.kind = Kind::file, .name = "FILE"},
         "also write the report as a page with diagrams to step through counterexamples",
         [](Options& o, const std::string& word) { o.output.html = word; }},
        {"--html", Group::output, verb_bit(Verb::step), {.kind = Kind::file, .name = "FILE"},
         "write a page to step through the reachable states in a browser, instead of using the terminal",
         [](Options& o, const std::string& word) { o.output.html = word; }},
        {"--html", Group::output, verb_bit(Verb::simulate), {.kind = Kind::file, .name = "FILE"},
         "also write a page that plays the trials, with the active states of each robot and plots over time",
         [](Options& o, const std::string& word) { o.output.html = word; }},
        {"--plot", Group::output, verb_bit(Verb::prism), {.kind = Kind::file, .name = "FILE"},
         "also plot the answers over the constant with the most values, as SVG",
         [](Options& o, const std::string& word) { o.prism.plot = word; }},
        {"--color", Group::output, limited | verb_bit(Verb::explain),
         {.kind = Kind::choice, .name = "WHEN", .usual = "auto", .choices = "auto,always,never"},
         "coloured text; auto: on a terminal, unless NO_COLOR is set",
         [](Options& o, const std::string& word) {
             o.output.color = static_cast<Color>(index_of(word, "auto,always,never"));
         }},
        {"-q,--quiet", Group::output, searching | verb_bit(Verb::simulate) | verb_bit(Verb::tune), {},
         "print only problems and the summary line", take_quiet},
        {"-q,--quiet", Group::output, verb_bit(Verb::prism), {}, "print the answers without sizes", take_quiet},
        {"-q,--quiet", Group::output, verb_bit(Verb::validate), {}, "print only findings", take_quiet},
        {"-q,--quiet", Group::output, verb_bit(Verb::draw), {}, "do not list the files written", take_quiet},
        {"-q,--quiet", Group::output, verb_bit(Verb::format), {}, "do not list the files changed", take_quiet},
        {"--provenance", Group::output, searching | verb_bit(Verb::prism) | verb_bit(Verb::simulate) | verb_bit(Verb::tune), {},
         "also print what is needed to repeat the run: version, command line, inputs, constants, ranges, limits",
         [](Options& o, const std::string&) { o.output.provenance = true; }},
        {"--trace", Group::output, checking | verb_bit(Verb::conform), {},
         "also print the raw event traces of counterexamples",
         [](Options& o, const std::string&) { o.output.show_internal = true; }},
        {"-b,--brief", Group::output, verb_bit(Verb::cspm), {}, "print verdicts without counterexamples",
         [](Options& o, const std::string&) { o.script.brief = true; }},
        {"--reveal-taus", Group::output, verb_bit(Verb::cspm), {}, "show hidden events by their names",
         [](Options& o, const std::string&) { o.script.reveal_taus = true; }},
        {"--split", Group::output, verb_bit(Verb::cspm), {},
         "show what every part of the process did, even if there are many parts",
         [](Options& o, const std::string&) { o.script.split = true; }},
        {"--export", Group::output, verb_bit(Verb::cspm),
         {.kind = Kind::choice, .name = "FORMAT PROCESS", .choices = "aut,dot,csp"},
         "write all states of a process (any expression of the script), then stop",
         [](Options& o, const std::string& word) {
             if (o.script.exported)
                 o.script.exported_process = word;
             else
                 o.script.exported = static_cast<GraphFormat>(index_of(word, "aut,dot,csp"));
         }},
        {"--export", Group::output, verb_bit(Verb::prism),
         {.kind = Kind::choice, .name = "FORMAT", .choices = "tra,sta,lab,dot,strategy,counterexample"},
         "instead of answers, write transitions, states, labels or a graph; for one property, write the strategy that "
         "attains its value, or the paths that violate its bound as a graph",
         [](Options& o, const std::string& word) {
             o.prism.exported = static_cast<SpaceExport>(1 + index_of(word, "tra,sta,lab,dot,strategy,counterexample"));
         }},
        {"--progress", Group::output, searching | verb_bit(Verb::simulate) | verb_bit(Verb::tune),
         {.kind = Kind::choice, .name = "HOW", .usual = "auto", .choices = "auto,json,never"},
         "progress on standard error; auto: a line that is updated on a terminal, otherwise a new line every half minute",
         [](Options& o, const std::string& word) {
             o.output.progress = static_cast<ProgressMode>(index_of(word, "auto,json,never"));
         }},
        {"--generate", Group::output, verb_bit(Verb::help),
         {.kind = Kind::choice, .name = "WHAT", .choices = "man,bash,zsh,fish"},
         "write the man page or the completion for a shell",
         [](Options& o, const std::string& word) {
             o.generate = static_cast<Generated>(1 + index_of(word, "man,bash,zsh,fish"));
         }},

        {"--memory", Group::limits, limited,
         {.kind = Kind::size, .name = "SIZE", .usual = "16GiB", .least = 1, .most = std::uint64_t{1} << 62U},
         "memory limit for the program and its child processes, e.g. 4GiB; the default is at most 3/4 of the machine's memory",
         [](Options& o, const std::string& word) { o.limits.memory_bytes = to_number(word); }},
        {"--timeout", Group::limits, limited,
         {.kind = Kind::seconds, .name = "SECONDS", .usual = "0", .most = 1'000'000'000},
         "time limit for the whole run in seconds; 0 for none",
         [](Options& o, const std::string& word) { o.limits.timeout_seconds = std::strtod(word.c_str(), nullptr); }},
        {"--assertion-timeout", Group::limits, checking | verb_bit(Verb::cspm),
         {.kind = Kind::seconds, .name = "SECONDS", .usual = "0", .most = 1'000'000'000},
         "time limit for each assertion in seconds; 0 for none: assertions then take turns",
         [](Options& o, const std::string& word) { o.limits.assertion_seconds = std::strtod(word.c_str(), nullptr); }},
        {"--threads", Group::limits, searching, {.kind = Kind::whole, .name = "N", .usual = "0", .most = 64},
         "maximum number of threads of a check, used if its state space is wide; 0 for one per core", take_threads},
        {"--threads", Group::limits, verb_bit(Verb::simulate) | verb_bit(Verb::tune), {.kind = Kind::whole, .name = "N", .usual = "0", .most = 64},
         "maximum number of parallel trials; 0 for one per core", take_threads},
        {"--threads", Group::limits, verb_bit(Verb::prism), {.kind = Kind::whole, .name = "N", .usual = "0", .most = 64},
         "maximum number of constant sets, answers or random paths in parallel; 0 for one per core", take_threads},
        {"--no-reduction", Group::limits, searching | verb_bit(Verb::tune), {},
         "search all states, without confluence and symmetry reduction",
         [](Options& o, const std::string&) { o.limits.reduction = false; }},
        {"--certify", Group::checking, deciding | verb_bit(Verb::conform), {.kind = Kind::folder, .name = "DIR"},
         "write a certificate for each claim that holds to this folder, for robochart-certify; the folder must be empty",
         [](Options& o, const std::string& word) { o.claims.certificates = word; }},
        {"--checkpoint", Group::limits, deciding, {.kind = Kind::folder, .name = "DIR"},
         "store checkpoints of searches in this folder, for --resume",
         [](Options& o, const std::string& word) { o.storage.checkpoint = word; }},
        {"--every", Group::limits, deciding,
         {.kind = Kind::seconds, .name = "MINUTES", .usual = "10", .most = 1'000'000},
         "minutes between checkpoints of --checkpoint, --resume and --disk; a run that ends at a limit also writes one",
         [](Options& o, const std::string& word) { o.storage.minutes_between = std::strtod(word.c_str(), nullptr); }},
        {"--resume", Group::limits, deciding, {.kind = Kind::folder, .name = "DIR"},
         "continue from the checkpoints in this folder, with the same model and options, and store new ones there",
         [](Options& o, const std::string& word) { o.storage.resume = word; }},
        {"--disk", Group::limits, deciding, {.kind = Kind::folder, .name = "DIR"},
         "store states that exceed --memory, and checkpoints, in this folder",
         [](Options& o, const std::string& word) { o.storage.disk = word; }},
        {"--max-states", Group::limits, verb_bit(Verb::prism),
         {.kind = Kind::whole, .name = "N", .usual = "500000000", .least = 1, .most = any_number},
         "maximum number of states of the model",
         [](Options& o, const std::string& word) { o.limits.max_states = to_number(word); }},
        {"--max-states", Group::limits, searching | verb_bit(Verb::tune),
         {.kind = Kind::whole, .name = "N", .usual = "500000000", .least = 1, .most = any_number},
         "maximum number of states of a check",
         [](Options& o, const std::string& word) { o.limits.max_states = to_number(word); }},

        {"--no-cache", Group::general, searching | verb_bit(Verb::simulate) | verb_bit(Verb::tune), {},
         "do not use or store results of earlier runs",
         [](Options& o, const std::string&) { o.cache = false; }},
        {"--stdio", Group::general, verb_bit(Verb::lsp), {},
         "ignored (client libraries of editors pass it): the server always uses standard input and output",
         [](Options&, const std::string&) {}},
        {"-h,--help", Group::general, all_verbs | no_verb, {}, "show the help of the program or of the verb", nullptr},
        {"--version", Group::general, no_verb, {}, "show the version", nullptr},
    };
    return rows;
}
// clang-format on

std::vector<const OptionRow*> options_of(Verbs verbs) {
    std::vector<const OptionRow*> rows;
    for (const OptionRow& row : option_table())
        if ((row.verbs & verbs) != 0) rows.push_back(&row);
    return rows;
}

std::string_view long_name(const OptionRow& row) {
    const std::string_view names = row.names;
    return names.substr(names.find("--"));
}

std::string_view short_name(const OptionRow& row) {
    const std::string_view names = row.names;
    return names.substr(0, names.find(',') == std::string_view::npos ? 0 : names.find(','));
}

std::vector<std::string> choices_of(const Argument& argument) {
    std::vector<std::string> words;
    std::istringstream list(argument.choices);
    for (std::string word; std::getline(list, word, ',');) words.push_back(word);
    return words;
}

std::size_t words_after(const Argument& argument) {
    const std::string_view name = argument.name;
    if (argument.kind == Argument::Kind::none) return 0;
    return 1 + static_cast<std::size_t>(std::ranges::count(name, ' '));
}

std::string did_you_mean(std::string_view word, const std::vector<std::string>& known) {
    std::string meant = diagnostics::nearest_spelling(word, known);
    std::set<std::string> begun;
    for (const std::string& candidate : known)
        if (word.size() > 1 && candidate.starts_with(word)) begun.insert(candidate);
    if (meant.empty() && begun.size() == 1) meant = *begun.begin();
    return meant.empty() ? "" : fmt::format("; did you mean '{}'?", meant);
}

namespace {

bool parse_whole(std::string_view text, std::uint64_t& value) {
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
    return code == std::errc() && end == text.data() + text.size();
}

/// Parses sizes such as "300M", "4GiB" and "1048576B". All units are binary, including "M" and "MB". A number without a
/// unit is rejected as ambiguous.
bool parse_size(std::string_view text, std::uint64_t& bytes) {
    const std::size_t digits = std::min(text.find_first_not_of("0123456789"), text.size());
    std::string unit(text.substr(digits));
    std::ranges::transform(unit, unit.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    unit.erase(0, std::min(unit.find_first_not_of(' '), unit.size()));
    constexpr std::string_view letters = "kmgtpe";
    std::size_t power = 0;
    if (unit.empty()) return false;
    if (unit != "b") {
        const std::size_t letter = letters.find(unit.front());
        const std::string_view rest = std::string_view(unit).substr(1);
        if (letter == std::string_view::npos || (!rest.empty() && rest != "b" && rest != "ib")) return false;
        power = letter + 1;
    }
    if (!parse_whole(text.substr(0, digits), bytes) || bytes > (any_number >> (10 * power))) return false;
    bytes <<= 10 * power;
    return true;
}

/// Parses a number of seconds. Rejects hexadecimal numbers, nan and infinity.
bool parse_seconds(const std::string& text, double& seconds) {
    char* end = nullptr;
    seconds = std::strtod(text.c_str(), &end);
    const bool plain = text.find_first_not_of("0123456789.eE+-") == std::string::npos;
    return plain && !text.empty() && *end == '\0' && std::isfinite(seconds);
}

/// True if the word is a number that the argument accepts. Rejects some texts that a number parser accepts (nan, -1,
/// 1e300).
bool is_number(const Argument& argument, const std::string& word, std::uint64_t& value) {
    if (argument.kind == Kind::seconds) {
        double seconds = 0;
        return parse_seconds(word, seconds) && seconds >= static_cast<double>(argument.least) &&
               seconds <= static_cast<double>(argument.most);
    }
    return (argument.kind == Kind::size ? parse_size(word, value) : parse_whole(word, value)) &&
           value >= argument.least && value <= argument.most;
}

std::string wanted_number(const Argument& argument) {
    if (argument.kind == Kind::size) return "expected a size above 0 with a unit, such as 300M or 4GiB";
    const std::string range = argument.most == any_number ? fmt::format("from {}", argument.least)
                                                          : fmt::format("from {} to {}", argument.least, argument.most);
    return fmt::format("expected a {} {}", argument.kind == Kind::seconds ? "number of seconds" : "whole number",
                       range);
}

std::string wrong_number(const Argument& argument, std::string& word) {
    std::uint64_t value = 0;
    if (!is_number(argument, word, value)) return fmt::format("{}: {}", word, wanted_number(argument));
    if (argument.kind == Kind::size) word = fmt::format("{}", value);
    return "";
}

std::string wrong_choice(const Argument& argument, const std::string& word) {
    const std::vector<std::string> known = choices_of(argument);
    if (std::ranges::find(known, word) != known.end()) return "";
    return fmt::format("'{}' is not one of {}{}", word, fmt::join(known, ", "), did_you_mean(word, known));
}

/// Returns an error unless the word is a number above 0 and below 1.
std::string wrong_fraction(const std::string& word) {
    double value = 0;
    const bool good = parse_seconds(word, value) && value > 0 && value < 1;
    return good ? "" : fmt::format("{}: expected a number between 0 and 1", word);
}

/// Returns an error unless the word is the code of a rule that warns.
std::string wrong_warning(std::string& code) {
    const auto warns = [](const std::string& candidate) {
        const auto rules = find_rules(candidate);
        return std::ranges::any_of(
            rules, [](const diagnostics::Rule* rule) { return rule->severity == diagnostics::Severity::warning; });
    };
    std::vector<std::string> meant_codes = codes_meant(code);
    std::erase_if(meant_codes, [&](const std::string& candidate) { return !warns(candidate); });
    if (meant_codes.size() == 1) {
        code = meant_codes.front();
        return "";
    }
    std::vector<std::string> known;
    for (const diagnostics::Rule* rule : all_rules())
        if (rule->severity == diagnostics::Severity::warning) known.emplace_back(rule->code);
    const std::string meant = did_you_mean(code, known);
    return fmt::format("{} is not the code of a warning{}", code,
                       meant.empty() ? " (robochart-verify explain lists them)" : meant);
}

}  // namespace

std::string wrong_word(const Argument& argument, std::size_t at, std::string& word) {
    switch (argument.kind) {
        case Kind::none:
        case Kind::text:
            return "";
        case Kind::choice:
            return at == 0 ? wrong_choice(argument, word) : "";
        case Kind::name:
        case Kind::file:
        case Kind::folder:
            return word.empty() ? "the name is empty" : "";
        case Kind::fraction:
            return wrong_fraction(word);
        case Kind::whole:
        case Kind::seconds:
        case Kind::size:
            return wrong_number(argument, word);
        case Kind::warning:
            return wrong_warning(word);
    }
    return "";
}

const std::vector<ExitRow>& exit_table() {
    static const std::vector<ExitRow> rows{
        {Exit::success, "success: every assertion holds as worded, the code conforms"},
        {Exit::failed,
         "an assertion fails, code does not conform, a simulation leaves its bands, or `format --check` finds "
         "unformatted files"},
        {Exit::bad_input, "the input is wrong, there is nothing to check, or the output cannot be written"},
        {Exit::inconclusive,
         "inconclusive: a limit was reached or the run was interrupted, and the results so far are printed; or a claim "
         "is of a kind that is not supported"},
        {Exit::usage, "wrong usage: unknown options or names, values out of range"},
        {Exit::internal, "internal error: please report it"},
    };
    return rows;
}

}  // namespace robochart::app
