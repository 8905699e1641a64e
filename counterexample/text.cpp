// SPDX-License-Identifier: Apache-2.0
// Prints runs as text. If the run has several machines, each step is printed with the machine that performs it.
#include "counterexample/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <vector>

#include "base/diagnostics/escape.hpp"
#include "counterexample/cycles.hpp"

namespace robochart::runs {
namespace {

constexpr std::size_t widest_column = 60;

std::string last_of(const std::string& path) {
    const auto at = path.rfind("::");
    return at == std::string::npos ? path : path.substr(at + 2);
}

struct Line {
    std::int64_t time = 0;
    std::string who, what, place;
};

class Writer {
public:
    Writer(const Run& run, std::string_view indent) : run_(run), indent_(indent) { name_machines(); }
    std::string write();

private:
    void name_machines();
    [[nodiscard]] std::string short_name(const std::string& component) const;
    [[nodiscard]] std::vector<Line> lines_of_steps(std::size_t begin, std::size_t end) const;
    [[nodiscard]] Line line_of_step(const Step& step) const;
    [[nodiscard]] std::vector<Line> loop_lines() const;
    [[nodiscard]] std::string machine_line(const Machine& machine) const;
    void add(const std::vector<Line>& lines);
    void add_cycles();
    [[nodiscard]] const std::vector<Machine>& at_the_end() const;

    const Run& run_;
    std::string_view indent_;
    std::map<std::string, std::string> short_names_;  ///< by machine, if there are several: its short name
    std::string out_;
};

void Writer::name_machines() {
    std::set<std::string> components;
    for (const Machine& machine : run_.initial) components.insert(machine.component);
    for (const Step& step : run_.steps)
        for (const Machine& machine : step.machines) components.insert(machine.component);
    if (components.size() < 2) return;
    std::map<std::string, int> uses;
    for (const std::string& component : components) ++uses[last_of(component)];
    for (const std::string& component : components)
        short_names_[component] = uses[last_of(component)] == 1 ? last_of(component) : component;
}

std::string Writer::short_name(const std::string& component) const {
    if (short_names_.empty() || component.empty()) return "";
    const auto found = short_names_.find(component);
    return found == short_names_.end() ? last_of(component) : found->second;
}

/// Returns the assignments immediately after time has passed, which are not separate steps.
std::vector<std::pair<std::string, std::string>> assignments_of(const Step& step) {
    std::vector<std::pair<std::string, std::string>> result;
    for (const Change& change : step.changes) {
        const std::string text = fmt::format("{} = {}", change.name, change.after);
        if (result.empty() || result.back().first != change.component)
            result.emplace_back(change.component, text);
        else
            result.back().second += ", " + text;
    }
    return result;
}

std::string passing_text(std::int64_t units, durations::Unit unit) {
    std::int64_t length = 0;
    const bool known = unit && !__builtin_mul_overflow(units, *unit, &length);
    return fmt::format("{} time unit{}{}", units, units == 1 ? " passes" : "s pass",
                       known ? fmt::format(" ({})", durations::duration_text(length)) : "");
}

Line Writer::line_of_step(const Step& step) const {
    Line result;
    result.time = step.time.value_or(0);
    result.who = short_name(step.event.component);
    result.what = text_of(step.event);
    for (const Event& other : step.with)
        result.what += fmt::format("; {}: {}", short_name(other.component), other.text);
    // Changes that the text of the event already contains are not repeated.
    std::vector<std::string> changes;
    for (const Change& change : step.changes) {
        const std::string text = fmt::format("{} = {}", change.name, change.after);
        if (!step.event.text.ends_with(text)) changes.push_back(text);
    }
    if (!changes.empty()) result.what += fmt::format("   [{}]", fmt::join(changes, ", "));
    if (step.event.place)
        result.place =
            fmt::format("{}:{}", diagnostics::escape_for_display(step.event.place->file), step.event.place->line);
    return result;
}

std::vector<Line> Writer::lines_of_steps(std::size_t begin, std::size_t end) const {
    std::vector<Line> result;
    for (std::size_t i = begin; i < end; ++i) {
        const Step& step = run_.steps[i];
        // The checks for termination add further termination events, which are not printed.
        const bool again = i > begin && step.event.kind == Kind::terminate && step.event.component.empty() &&
                           run_.steps[i - 1].event.kind == Kind::terminate;
        if (is_news(step) && !again) result.push_back(line_of_step(step));
        if (step.event.kind != Kind::tock) continue;
        for (const auto& [component, values] : assignments_of(step))
            result.push_back({step.time.value_or(0) + step.units, short_name(component), values, ""});
    }
    return result;
}

void Writer::add(const std::vector<Line>& lines) {
    std::size_t names = 0;
    std::size_t words = 0;
    std::size_t times = 6;  // "t=1000"
    for (const Line& line : lines) {
        times = std::max(times, durations::time_text(line.time, run_.unit).size());
        names = std::max(names, line.who.size());
        words = std::max(words, line.what.size());
    }
    for (const Line& line : lines) {
        out_ += indent_;
        if (run_.timed) out_ += fmt::format("{:<{}} ", durations::time_text(line.time, run_.unit), times);
        if (names > 0) out_ += fmt::format("{:<{}}   ", line.who, names);
        if (line.place.empty())
            out_ += line.what;
        else
            out_ += fmt::format("{:<{}}   {}", line.what, std::min(words, widest_column), line.place);
        out_ += '\n';
    }
}

std::string Writer::machine_line(const Machine& machine) const {
    const std::string values = values_text(machine);
    std::string text = machine.text;
    if (!short_names_.empty()) text = fmt::format("{}: {}", short_name(machine.component), text);
    return values.empty() ? text : fmt::format("{} ({})", text, values);
}

const std::vector<Machine>& Writer::at_the_end() const {
    const std::size_t end = run_.loop_start.value_or(run_.steps.size());
    return end == 0 ? run_.initial : run_.steps[end - 1].machines;
}

std::vector<Line> Writer::loop_lines() const {
    std::vector<Line> result = lines_of_steps(*run_.loop_start, run_.steps.size());
    std::int64_t units = 0;
    for (std::size_t i = *run_.loop_start; i < run_.steps.size(); ++i) units += run_.steps[i].units;
    if (units > 0) result.push_back({run_.time, "", passing_text(units, run_.unit), ""});
    if (result.empty()) result.push_back({run_.time, "", "internal steps that change nothing", ""});
    return result;
}

void Writer::add_cycles() {
    const std::vector<RunCycle> cycles = cycles_of(run_);
    for (std::size_t i = 0; i < cycles.size(); ++i)
        out_ += fmt::format("{}cycle {:<3} {}\n", indent_, i + 1, text_of(cycles[i]));
}

std::string Writer::write() {
    const std::size_t end = run_.loop_start.value_or(run_.steps.size());
    std::vector<Line> run = lines_of_steps(0, end);
    const std::int64_t shown = run.empty() ? 0 : run.back().time;
    if (run_.time > shown) run.push_back({shown, "", passing_text(run_.time - shown, run_.unit), ""});
    add(run);
    std::vector<std::string> places;
    for (const Machine& machine : at_the_end()) places.push_back(machine_line(machine));
    if (!places.empty()) {
        out_ += run_.timed ? fmt::format("{}now at {}: ", indent_, durations::time_text(run_.time, run_.unit))
                           : fmt::format("{}now ", indent_);
        out_ += fmt::format("{}\n", fmt::join(places, "; "));
    }
    if (run_.loop_start) {
        out_ += fmt::format("{}then for ever:\n", indent_);
        add(loop_lines());
    }
    add_cycles();
    if (!run_.end.why.empty()) out_ += fmt::format("{}why {}\n", indent_, run_.end.why);
    return std::move(out_);
}

}  // namespace

bool is_news(const Step& step) {
    if (step.event.kind == Kind::tock) return false;
    if (!step.changes.empty() || !step.hidden) return true;
    switch (step.event.kind) {
        case Kind::internal:
        case Kind::entered:
        case Kind::exited:
        case Kind::external_write:
            return false;
        case Kind::transition:
        case Kind::input:
        case Kind::output:
        case Kind::call:
        case Kind::assignment:
        case Kind::tock:
        case Kind::terminate:
        case Kind::refusal:
        case Kind::event:
        case Kind::read:
        case Kind::empty_read:
            break;
        case Kind::cycle_end:
            return false;
    }
    return true;
}

std::string text_of(const Event& event) {
    const bool by_transition = event.kind == Kind::input && event.via.find(" -> ") != std::string::npos;
    return by_transition ? fmt::format("{} ({})", event.text, event.via) : event.text;
}

std::string text_of(const Event& event, const std::vector<Event>& with) {
    std::string result = text_of(event);
    for (const Event& other : with) result += fmt::format("; {}: {}", other.component, other.text);
    return result;
}

std::string values_text(const Machine& machine) {
    std::vector<std::string> values;
    for (const Variable& variable : machine.variables)
        if (variable.kind != VariableKind::constant && variable.value)
            values.push_back(fmt::format("{} = {}", variable.name, *variable.value));
    return fmt::format("{}", fmt::join(values, ", "));
}

std::string text_of(const Machine& machine) {
    const std::string values = values_text(machine);
    return values.empty() ? machine.text : fmt::format("{}, {}", machine.text, values);
}

std::string text_of(const Run& run, std::string_view indent) {
    return Writer(run, indent).write();
}

std::string short_text_of(const Run& run) {
    std::string result, now;
    std::int64_t time = 0;
    const bool timed = std::ranges::any_of(run.steps, [](const Step& step) { return step.time.has_value(); });
    const auto end = [&] {
        if (now.empty()) return;
        result += (result.empty() ? "" : "; ") + now;
        if (timed) result += fmt::format(" at time {}", time);
        now.clear();
    };
    for (const Step& step : run.steps) {
        if (step.event.kind == Kind::tock) {
            end();
            time += step.units;
        }
        const bool shown = step.event.kind == Kind::input || step.event.kind == Kind::output ||
                           step.event.kind == Kind::call || step.event.kind == Kind::assignment;
        if (shown && !step.hidden) now += (now.empty() ? "" : ", ") + step.event.text;
    }
    end();
    return result;
}

}  // namespace robochart::runs
