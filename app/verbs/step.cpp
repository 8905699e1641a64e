// SPDX-License-Identifier: Apache-2.0
// The verb `step`: steps through a component, or a process of a script, by hand in the terminal. Commands are read from
// standard input, one per line; docs/step.md describes them.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <iostream>
#include <map>
#include <optional>
#include <set>
#include <sstream>

#include "app/command/findings.hpp"
#include "app/command/option_table.hpp"
#include "app/command/output.hpp"
#include "app/command/recording.hpp"
#include "app/command/run.hpp"
#include "app/command/script.hpp"
#include "app/report/structure_text.hpp"
#include "app/step/step_files.hpp"
#include "app/step/step_page.hpp"
#include "app/step/stepped_component.hpp"
#include "app/verbs/verbs.hpp"
#include "base/diagnostics/files.hpp"
#include "base/diagnostics/splitmix64.hpp"
#include "checker/cspm/session.hpp"
#include "checker/cspm/syntax/reader.hpp"
#include "checker/process/operational_semantics.hpp"
#include "conformance/model/renamed_model.hpp"
#include "counterexample/cycles.hpp"
#include "counterexample/evaluation_failure.hpp"
#include "counterexample/stepper.hpp"
#include "counterexample/text.hpp"
#include "driver/model/pipeline.hpp"
#include "semantics/instantiate/instantiate.hpp"
#include "semantics/ir/query.hpp"

namespace robochart::app {
namespace {

/// The maximal number of hidden steps that are taken automatically while no other step is possible.
constexpr std::size_t most_settled = 10'000;
/// The maximal number of steps in which `until` searches for its condition.
constexpr std::size_t most_until = 100'000;

std::string place_of(const std::optional<runs::Place>& place) {
    return place ? fmt::format("   {}:{}", place->file, place->line) : "";
}

std::string text_of(const runs::Offer& offer) {
    return runs::text_of(offer.happening.event, offer.happening.with);
}

class Console {
public:
    Console(runs::Stepper& stepper, const Options& options, Stepped stepped)
        : stepper_(stepper), options_(options), stepped_(std::move(stepped)) {}

    /// Runs until the input ends. Returns the exit code, which is a failure if the input is a file with wrong commands.
    Exit run();

private:
    /// A command of the terminal.
    struct Command {
        const char* name;
        const char* argument;
        const char* help;
        void (Console::*obey)(const std::string& argument);  ///< null for numbers
    };
    /// Returns all commands. A prefix selects the first command in this list whose name begins with the prefix.
    static const std::vector<Command>& command_table();

    void run_command_line(const std::string& line);
    bool take_offer(const std::string& word);
    void undo_steps(const std::string& word);
    void pass_time(const std::string& word);
    void take_random_steps(const std::string& word);
    void run_cycle(const std::string& words);
    [[nodiscard]] bool read_registers(const std::map<std::string, std::string>& given);
    [[nodiscard]] std::optional<std::size_t> choose_read(const std::map<std::string, std::string>& given) const;
    [[nodiscard]] static bool is_open_read(const std::vector<runs::Offer>& offers, std::size_t offer);
    [[nodiscard]] bool at_reads() const;
    void end_cycle();
    bool take_hidden_steps();
    void take(std::size_t offer);
    void step_until(const std::string& text);
    void explain_absences(const std::string& text);
    void find(const std::string& text);
    [[nodiscard]] std::string leads_to(std::size_t offer);
    bool list_offers(const std::string& text);  ///< lists the offers with this text; returns false if there are none
    void watch_component(const std::string& name);
    void print_way(const std::string&);
    void print_tree(const std::string&);
    void toggle_internal(const std::string&);
    void print_help(const std::string&);
    void quit(const std::string&) { quits_ = true; }
    void save_log(const std::string& path);
    void load_log(const std::string& path);
    void settle_hidden();
    void show_state();
    void report_wrong(const std::string& text);
    [[nodiscard]] bool take_random_offer();
    /// True if a step after the first `steps` steps contains the text, or if the current state of a machine does.
    [[nodiscard]] bool has_occurred(const std::string& text, std::size_t steps);
    std::optional<std::size_t> read_number(const std::string& word, std::size_t otherwise);

    runs::Stepper& stepper_;
    const Options& options_;
    Stepped stepped_;
    std::vector<std::size_t> choices_;  ///< for each choice, the number of steps before it
    std::string watched_;
    std::uint64_t chance_ = 1;  ///< state of the random generator; its fixed start makes runs repeatable
    bool internal_ = false;
    bool failed_ = false, quits_ = false;
    bool person_ = isatty(STDIN_FILENO) == 1;
};

void Console::report_wrong(const std::string& text) {
    print_error("{}\n", text);
    failed_ = true;
}

std::optional<std::size_t> Console::read_number(const std::string& word, std::size_t otherwise) {
    if (word.empty()) return otherwise;
    std::size_t value = 0;
    const auto [end, code] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (code == std::errc() && end == word.data() + word.size() && value <= 1'000'000) return value;
    report_wrong(fmt::format("{}: expected a whole number, at most 1000000", word));
    return std::nullopt;
}

void Console::settle_hidden() {
    if (!internal_) stepper_.take_forced_steps(most_settled);
}

void Console::show_state() {
    std::string heading = stepped_.name;
    const durations::Unit unit = stepped_.project == nullptr ? std::nullopt : stepped_.project->unit;
    if (stepped_.time == csp_emit::Time::timed) heading += ", " + durations::time_text(stepper_.elapsed_time(), unit);
    print("\n{}, step {}\n", heading, stepper_.steps_taken().size());
    const std::vector<runs::Machine> machines = stepper_.current_machines();
    for (const runs::Machine& machine : machines) {
        if (watched_.empty()) print("  {}: {}\n", machine.component, runs::text_of(machine));
        for (const runs::Variable& variable : machine.variables)
            if (variable.name == watched_ || variable.name == fmt::format("since({})", watched_))
                print("  {}: {} = {}\n", machine.component, variable.name, variable.value.value_or("-"));
    }
    if (machines.empty())
        print("  {}\n", process::describe(stepper_.reader().context().session.terms(), stepper_.current_term()));
    const std::vector<runs::Offer>& offers = stepper_.current_offers();
    for (std::size_t i = 0; i < offers.size(); ++i)
        print("{:>4}  {}{}{}{}\n", i + 1, offers[i].hidden ? "(hidden) " : "", text_of(offers[i]), leads_to(i),
              place_of(offers[i].happening.event.place));
    if (offers.empty()) print("      nothing can happen any more\n");
}

/// Returns the target of an offer, such as " to STOP". It is shown for processes of scripts if several offers have the
/// same text.
std::string Console::leads_to(std::size_t offer) {
    const std::vector<runs::Offer>& offers = stepper_.current_offers();
    const auto same = [&](const runs::Offer& other) {
        return other.hidden == offers[offer].hidden && text_of(other) == text_of(offers[offer]);
    };
    if (stepped_.project || std::ranges::count_if(offers, same) == 1) return "";
    process::TermStore& terms = stepper_.reader().context().session.terms();
    return "   to " + process::describe(terms, offers[offer].step.target);
}

bool Console::take_offer(const std::string& word) {
    std::size_t offer = 0;
    const auto [end, code] = std::from_chars(word.data(), word.data() + word.size(), offer);
    if (code != std::errc() || end != word.data() + word.size()) return false;
    if (offer < 1 || offer > stepper_.current_offers().size()) {
        report_wrong(fmt::format("there is no offer {}", word));
        return true;
    }
    choices_.push_back(stepper_.steps_taken().size());
    stepper_.take_offer(offer - 1);
    settle_hidden();
    show_state();
    return true;
}

void Console::undo_steps(const std::string& word) {
    if (word.empty()) {
        if (choices_.empty()) return report_wrong("there is no choice to go back from");
        stepper_.back_to(choices_.back());
        choices_.pop_back();
        return show_state();
    }
    const auto steps = read_number(word, 0);
    if (!steps) return;
    if (*steps > stepper_.steps_taken().size())
        return report_wrong(fmt::format("the way has only {} steps", stepper_.steps_taken().size()));
    stepper_.back_to(*steps);
    while (!choices_.empty() && choices_.back() >= *steps) choices_.pop_back();
    show_state();
}

void Console::pass_time(const std::string& word) {
    const auto units = read_number(word, 1);
    for (std::size_t i = 0; units && i < *units; ++i) {
        options_.run->budget().poll();
        const std::vector<runs::Offer>& offers = stepper_.current_offers();
        if (offers.empty() || offers.back().happening.event.kind != runs::Kind::tock) {
            report_wrong("time cannot pass here");
            break;
        }
        choices_.push_back(stepper_.steps_taken().size());
        stepper_.take_offer(offers.size() - 1);
        settle_hidden();
    }
    show_state();
}

/// Returns false if no step is possible.
bool Console::take_random_offer() {
    options_.run->budget().poll();
    const std::size_t offers = stepper_.current_offers().size();
    if (offers == 0) return false;
    choices_.push_back(stepper_.steps_taken().size());
    stepper_.take_offer(diagnostics::splitmix64(chance_) % offers);
    settle_hidden();
    return true;
}

void Console::take_random_steps(const std::string& word) {
    const auto steps = read_number(word, 1);
    for (std::size_t i = 0; steps && i < *steps && take_random_offer(); ++i) {
    }
    show_state();
}

void Console::take(std::size_t offer) {
    choices_.push_back(stepper_.steps_taken().size());
    stepper_.take_offer(offer);
    settle_hidden();
}

namespace {

bool is_read(const runs::Event& event) {
    return event.kind == runs::Kind::read || event.kind == runs::Kind::empty_read;
}

/// Parses the inputs of `cycle`: "pressed", "e=3". A name without a value gets the value "".
std::map<std::string, std::string> read_inputs(const std::string& words) {
    std::map<std::string, std::string> result;
    std::istringstream in(words);
    for (std::string word; in >> word;) {
        const std::size_t equal = word.find('=');
        result[word.substr(0, equal)] = equal == std::string::npos ? "" : word.substr(equal + 1);
    }
    return result;
}

}  // namespace

/// True for a read of the environment, and for a hidden read whose result is open: a register that no connection fills
/// has any content (docs/robosim.md, "Controllers and modules").
bool Console::is_open_read(const std::vector<runs::Offer>& offers, std::size_t offer) {
    const runs::Event& event = offers[offer].happening.event;
    if (!is_read(event)) return false;
    if (!offers[offer].hidden) return true;
    const std::string name = read_register(offers[offer])->name;
    return std::ranges::count_if(offers, [&](const runs::Offer& other) {
               return other.hidden && is_read(other.happening.event) &&
                      other.happening.event.component == event.component && read_register(other)->name == name;
           }) > 1;
}

bool Console::at_reads() const {
    const auto offers = stepper_.offers_at(stepper_.current_term());
    for (std::size_t i = 0; i < offers.size(); ++i)
        if (is_open_read(offers, i)) return true;
    return false;
}

/// Selects the offered read that fits the given inputs. The register of an event that the command does not give is read
/// as empty. A variable that the command does not give is read with its last value. Returns no value if no read fits.
std::optional<std::size_t> Console::choose_read(const std::map<std::string, std::string>& given) const {
    const std::vector<runs::Offer> offers = stepper_.offers_at(stepper_.current_term());
    const KeptValues kept(stepper_.steps_taken(), stepped_);
    std::optional<std::size_t> first;
    for (std::size_t i = 0; i < offers.size(); ++i) {
        if (!is_open_read(offers, i)) continue;
        const runs::Event& event = offers[i].happening.event;
        const ReadRegister read = *read_register(offers[i]);
        const auto value = given.find(read.name);
        if (value != given.end()) {
            if (event.kind == runs::Kind::read && read.value == value->second) return i;
            continue;
        }
        if (event.kind == runs::Kind::empty_read) return i;
        if (read.event) continue;
        if (kept.is_kept(offers[i])) return i;
        if (!first) first = i;
    }
    return first;
}

/// Reads all registers of the cycle. Parts of a component may read theirs after hidden steps.
bool Console::read_registers(const std::map<std::string, std::string>& given) {
    std::set<std::string> read;
    for (std::size_t steps = 0; steps < most_settled; ++steps) {
        if (!at_reads()) {
            if (std::ranges::none_of(stepper_.current_offers(), &runs::Offer::hidden) || !take_hidden_steps()) break;
            continue;
        }
        const auto offer = choose_read(given);
        if (!offer) {
            report_wrong("an input has no such value: the offers show which values it has");
            return false;
        }
        read.insert(read_register(stepper_.current_offers()[*offer])->name);
        take(*offer);
    }
    for (const auto& [name, value] : given)
        if (!read.contains(name)) {
            report_wrong(fmt::format("{} is not an input that is read in this cycle", name));
            return false;
        }
    return true;
}

/// Takes the hidden steps that are possible here, except open reads, if their order does not matter. This is the case
/// if all orders lead to the same state without such steps, and this state offers every visible event that a state on
/// the way offers. Otherwise takes no step and returns false.
bool Console::take_hidden_steps() {
    struct Node {
        process::TermId term{};
        std::size_t parent = 0, offer = 0;
    };
    std::vector<Node> nodes{{stepper_.current_term(), 0, 0}};
    std::set<process::TermId> seen{nodes.front().term};
    std::set<std::string> visible, at_end;
    std::optional<std::size_t> end;
    for (std::size_t at = 0; at < nodes.size(); ++at) {
        options_.run->budget().poll();
        if (nodes.size() > most_settled) return false;
        bool stable = true;
        std::set<std::string> names;
        const std::vector<runs::Offer> offers = stepper_.offers_at(nodes[at].term);
        for (std::size_t i = 0; i < offers.size(); ++i) {
            if (!offers[i].hidden) names.insert(offers[i].name);
            if (!offers[i].hidden || is_open_read(offers, i)) continue;
            stable = false;
            if (seen.insert(offers[i].step.target).second) nodes.push_back({offers[i].step.target, at, i});
        }
        if (stable && end) return false;
        if (stable) end = at;
        (stable ? at_end : visible).insert(names.begin(), names.end());
    }
    if (!end || *end == 0 || !std::ranges::includes(at_end, visible)) return false;
    std::vector<std::size_t> way;
    for (std::size_t at = *end; at != 0; at = nodes[at].parent) way.push_back(nodes[at].offer);
    choices_.push_back(stepper_.steps_taken().size());
    for (auto offer = way.rbegin(); offer != way.rend(); ++offer) stepper_.take_offer(*offer);
    return true;
}

/// Takes steps while only one step is possible, then lets the time units of the cycle pass.
void Console::end_cycle() {
    for (std::size_t steps = 0; steps < most_settled; ++steps) {
        options_.run->budget().poll();
        const std::vector<runs::Offer>& offers = stepper_.current_offers();
        if (offers.empty()) return report_wrong("time stops: the component can neither go on nor end its cycle");
        if (std::ranges::any_of(offers, &runs::Offer::hidden) && take_hidden_steps()) continue;
        if (offers.back().happening.event.kind == runs::Kind::tock) break;
        if (offers.size() > 1)
            return report_wrong("several steps are possible: take one by its number, then `cycle` goes on");
        take(0);
    }
    for (std::uint32_t unit = 0; unit < *stepped_.cycle; ++unit) {
        const std::vector<runs::Offer>& offers = stepper_.current_offers();
        if (offers.empty() || offers.back().happening.event.kind != runs::Kind::tock) break;
        take(offers.size() - 1);
    }
}

void Console::run_cycle(const std::string& words) {
    if (!stepped_.cycle) return report_wrong("only RoboSim components run in cycles");
    if (read_registers(read_inputs(words))) end_cycle();
    const std::vector<runs::RunCycle> cycles = runs::cycles_of(stepper_.run(stepped_.time));
    if (!cycles.empty()) print("cycle {}   {}\n", cycles.size(), runs::text_of(cycles.back()));
    show_state();
}

bool Console::has_occurred(const std::string& text, std::size_t steps) {
    const std::vector<runs::Taken>& way = stepper_.steps_taken();
    for (std::size_t i = steps; i < way.size(); ++i)
        if (text_of(way[i].offer).find(text) != std::string::npos) return true;
    for (const runs::Machine& machine : stepper_.current_machines())
        if (runs::text_of(machine).find(text) != std::string::npos) return true;
    return false;
}

void Console::step_until(const std::string& text) {
    if (text.empty()) return report_wrong("until what?");
    std::size_t steps = 0;
    bool goes_on = true;
    std::size_t before = 0;
    do {
        before = stepper_.steps_taken().size();
        goes_on = take_random_offer();
    } while (goes_on && ++steps < most_until && !has_occurred(text, before));
    if (!goes_on || steps == most_until) report_wrong(fmt::format("`{}` was not met in {} choices", text, steps));
    show_state();
}

void Console::explain_absences(const std::string& text) {
    std::size_t shown = 0;
    for (const runs::Absence& absence : stepper_.explain_absences()) {
        if (absence.text.find(text) == std::string::npos) continue;
        print("  {}: {}: {}{}\n", absence.component, absence.text, absence.reason, place_of(absence.place));
        ++shown;
    }
    if (shown > 0) return;
    if (stepped_.project)
        print("  {}\n", text.empty() ? "every transition that leaves an active state is on offer"
                                     : "no other transition that leaves an active state has this text");
    else if (text.empty())
        print("  every event that a component offers is on offer\n");
    else if (!list_offers(text))
        print("  no component offers an event with this text (`tree` shows what each offers)\n");
}

void Console::find(const std::string& text) {
    list_offers(text);
}

bool Console::list_offers(const std::string& text) {
    bool found = false;
    const std::vector<runs::Offer>& offers = stepper_.current_offers();
    for (std::size_t i = 0; i < offers.size(); ++i) {
        if (text_of(offers[i]).find(text) == std::string::npos) continue;
        print("{:>4}  {}{}\n", i + 1, text_of(offers[i]), leads_to(i));
        found = true;
    }
    return found;
}

void Console::print_way(const std::string&) {
    if (!stepped_.project) {
        std::vector<std::string> names;
        for (const runs::Taken& step : stepper_.steps_taken())
            names.push_back(step.offer.hidden ? fmt::format("τ({})", step.offer.name) : step.offer.name);
        return app::print_text(fmt::format("  <{}>\n", fmt::join(names, ", ")));
    }
    app::print_text(runs::text_of(stepper_.run(stepped_.time), "  "));
}

void Console::save_log(const std::string& path) {
    const std::string error = save_way(stepper_, stepped_, path, *options_.run);
    if (!error.empty()) return report_wrong(error);
    print("{}\n", path);
}

void Console::load_log(const std::string& path) {
    const Followed followed = follow_log(stepper_, stepped_, path, *options_.run);
    choices_.clear();
    if (!followed.error.empty()) report_wrong(followed.error);
    settle_hidden();
    show_state();
}

void Console::watch_component(const std::string& name) {
    watched_ = name;
    show_state();
}

void Console::print_tree(const std::string&) {
    print("{}", structure_text(stepper_.current_structure(), stepper_.reader().context().session.event_table()));
}

void Console::toggle_internal(const std::string&) {
    internal_ = !internal_;
    settle_hidden();
    show_state();
}

void Console::print_help(const std::string&) {
    for (const Command& command : command_table())
        print("  {:<16} {}\n", fmt::format("{} {}", command.name, command.argument), command.help);
}

const std::vector<Console::Command>& Console::command_table() {
    static const std::vector<Command> all = {
        {"N", "", "take the offer of this number", nullptr},
        {"undo", "[N]", "go back one choice, or to step N of the way", &Console::undo_steps},
        {"tock", "[N]", "let N time units pass, one without N, as far as nothing has to happen first",
         &Console::pass_time},
        {"cycle", "[INPUT]...", "RoboSim: run to the end of a cycle with these inputs: `cycle pressed speed=2`",
         &Console::run_cycle},
        {"random", "[N]", "take N offers by chance, one without N", &Console::take_random_steps},
        {"until", "TEXT", "take offers by chance until a state, a value or an event with this text",
         &Console::step_until},
        {"why", "[TEXT]", "why transitions that leave active states, or events of components, are not on offer",
         &Console::explain_absences},
        {"find", "TEXT", "the offers with this text", &Console::find},
        {"watch", "[NAME]", "show this variable alone; all without NAME", &Console::watch_component},
        {"way", "", "how it has come here", &Console::print_way},
        {"tree", "", "the structure of the process, its operators and components", &Console::print_tree},
        {"internal", "", "stop at hidden steps too, or do not any more", &Console::toggle_internal},
        {"save", "FILE",
         "write the way: FILE.trace or FILE.mcap a log, FILE.assertions an assertion that it stays possible",
         &Console::save_log},
        {"load", "FILE", "go the way of a log from the beginning", &Console::load_log},
        {"help", "", "this list", &Console::print_help},
        {"quit", "", "leave", &Console::quit},
    };
    return all;
}

void Console::run_command_line(const std::string& line) {
    std::istringstream words(line);
    std::string name, rest;
    words >> name;
    std::getline(words >> std::ws, rest);
    while (!rest.empty() && std::isspace(static_cast<unsigned char>(rest.back())) != 0) rest.pop_back();
    if (name.empty() || take_offer(name)) return;
    std::vector<std::string> known;
    for (const Command& command : command_table()) {
        if (command.obey != nullptr && std::string_view(command.name).starts_with(name))
            return (this->*command.obey)(rest);
        known.emplace_back(command.name);
    }
    report_wrong(fmt::format("there is no command '{}'{}; `help` lists them", name, did_you_mean(name, known)));
}

Exit Console::run() {
    settle_hidden();
    show_state();
    for (std::string line;;) {
        if (person_) print("> ");
        finish_output();
        if (!std::getline(std::cin, line)) break;
        options_.run->budget().poll();
        run_command_line(line);
        if (quits_) break;
    }
    return failed_ && !person_ ? Exit::failed : Exit::success;
}

/// Writes the page of `--html`. If a limit is reached while the states are explored, the page contains the states found
/// so far.
Exit write_page(runs::Stepper& stepper, const Options& options, const Stepped& stepped,
                const std::vector<driver::Part>& parts) {
    diagnostics::Budget& budget = options.run->budget();
    const runs::Exploration space = runs::explore_process(stepper.reader(), stepper.current_term(), {}, budget);
    const std::string reached = budget.reached_limit();
    options.run->finish();
    const std::string error =
        diagnostics::replace_file(options.output.html, step_page(space, stepped, parts, record_of(options)), &budget);
    if (!error.empty()) {
        print_error("robochart-verify: {}\n", error);
        return Exit::bad_input;
    }
    print("{}: {}\n", options.output.html, counts_text(space));
    const auto wrong = std::ranges::find_if(space.states, [](const auto& state) { return !state.error.empty(); });
    if (wrong != space.states.end()) {
        print_error("robochart-verify: {}\n", wrong->error);
        return Exit::bad_input;
    }
    return reached.empty() ? Exit::success : Exit::inconclusive;
}

/// Steps in the terminal, or writes the page.
Exit run_stepper(runs::Stepper& stepper, const Options& options, const Stepped& stepped,
                 const std::vector<driver::Part>& parts) {
    return options.output.html.empty() ? Console(stepper, options, stepped).run()
                                       : write_page(stepper, options, stepped, parts);
}

/// The components that can be stepped through, each with its part.
using Candidates = std::vector<std::pair<driver::Project*, ir::ComponentRef>>;

Candidates candidate_components(const std::vector<driver::Part>& parts, const std::string& component_name) {
    Candidates result;
    for (const driver::Part& part : parts)
        if (part.project->diagnostics.ok() && !part.again)
            for (const ir::ComponentRef& component :
                 driver::code_components(part.project->system, component_name, true))
                result.emplace_back(part.project.get(), component);
    return result;
}

/// Returns the selected component. Throws UsageError unless exactly one component matches.
std::pair<driver::Project*, ir::ComponentRef> find_meant_component(const std::vector<driver::Part>& parts,
                                                                   const std::string& component_name) {
    const Candidates found = candidate_components(parts, component_name);
    if (found.size() == 1) return found.front();
    std::vector<std::string> names;
    for (const auto& [project, component] : found.empty() ? candidate_components(parts, "") : found)
        names.push_back(driver::component_name(project->system, component));
    std::vector<std::string> known = names;  // names with and without their packages
    for (const std::string& name : names) known.push_back(name.substr(name.rfind(':') + 1));
    if (found.empty())
        throw UsageError(fmt::format("the model has no component '{}'{}; it has {}", component_name,
                                     did_you_mean(component_name, known), fmt::join(names, ", ")));
    throw UsageError(fmt::format("which component? {}", fmt::join(names, ", ")));
}

Exit step_component(const Options& options) {
    driver::Settings model = options;
    model.load.inputs.resize(1);
    const std::vector<driver::Part> parts = driver::load_parts(model, options.run->budget());
    record_projects(parts, model, options);
    for (const driver::Part& part : parts)
        if (!show_diagnostics(*part.project, options)) return refusal_code(*part.project);
    const auto [project, component] =
        find_meant_component(parts, options.load.inputs.size() > 1 ? options.load.inputs[1] : "");
    const csp_emit::Time time =
        options.claims.times == driver::Times::untimed ? csp_emit::Time::untimed : csp_emit::Time::timed;
    (void)emit_csp(*project, options.claims, options.swarm, time);
    if (!project->diagnostics.ok()) {
        show_findings(*project, options);
        return refusal_code(*project);
    }
    record_block_values(*project, options);
    std::optional<std::uint32_t> cycle;
    if (ir::is_robosim(project->system, component)) {
        if (time == csp_emit::Time::untimed)
            throw UsageError(
                fmt::format("{} is written in RoboSim, which has no untimed semantics", ir::qualified_name(component)));
        cycle = static_cast<std::uint32_t>(ir::cycle_of(project->system, project->instantiation, component));
    }
    diagnostics::Diagnostics apart;  // discarded, because the script has reported the same findings
    const ir::ComponentRef inside =
        conformance::renamed_model(project->system, project->instantiation, component, apart).component;
    try {
        SteppedComponent stepped(*project, ir::qualified_name(inside), time, options);
        return run_stepper(stepped.stepper(), options,
                           {ir::qualified_name(component), options.load.inputs.front(), project, time, cycle}, parts);
    } catch (const cspm::EvaluationError& error) {
        print_error("robochart-verify: {}\n", runs::placed_failure(error, project->system, project->sources));
        return Exit::bad_input;
    }
}

Exit step_script(const Options& options) {
    if (options.load.inputs.size() < 2) throw UsageError("step needs a process of the script: `step FILE.csp PROCESS`");
    LoadedScript loaded;
    loaded.diagnostics.set_budget(&options.run->budget());
    load_script(options.load.inputs.front(), loaded);
    record_texts(loaded.sources, options);
    const cspm::DeclPtr parsed =
        loaded.diagnostics.ok() ? parse_process(loaded, options.load.inputs[1], options.load.inputs[1]) : nullptr;
    if (!parsed) {
        show_findings(loaded, options);
        return Exit::bad_input;
    }
    const ir::System no_system;
    try {
        cspm::Session session(loaded.script, &options.run->budget());
        const csp_emit::Provenance nothing;
        const ir::Instantiation no_instantiation;
        const runs::Context context{nothing, no_system, no_instantiation, loaded.sources, session};
        runs::StepReader reader(context);
        runs::Stepper stepper(reader, session.process(parsed->assertion.specification));
        return run_stepper(stepper, options,
                           {options.load.inputs[1], options.load.inputs.front(), nullptr, csp_emit::Time::untimed}, {});
    } catch (const cspm::EvaluationError& error) {
        print_error("robochart-verify: {}\n", runs::placed_failure(error, no_system, loaded.sources));
        return Exit::bad_input;
    }
}

}  // namespace

Exit run_step(const Options& options) {
    if (options.load.inputs.size() > 2)
        throw UsageError("step takes a model and a component, or a script and a process");
    options.run->last_word([](const std::string& why) {
        print_error("robochart-verify: {}\n", why);
        return Exit::inconclusive;
    });
    const std::string extension = std::filesystem::path(options.load.inputs.front()).extension().string();
    const bool script = extension == ".csp" || extension == ".cspm" || extension == ".fdr3";
    return script ? step_script(options) : step_component(options);
}

}  // namespace robochart::app
