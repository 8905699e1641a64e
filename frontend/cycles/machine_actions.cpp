// SPDX-License-Identifier: Apache-2.0
// Writes statements. A statement that ends no cycle, or a known small number of cycles, stays in its action. Other
// statements become transitions with junctions between them. No other transition can be taken while the machine is in a
// junction, as none can be taken during an action.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>

#include "frontend/cycles/copies.hpp"
#include "frontend/cycles/event_reuse.hpp"
#include "frontend/cycles/machine_writer.hpp"
#include "frontend/names/scopes.hpp"
#include "frontend/syntax/expression_visitor.hpp"
#include "frontend/syntax/print.hpp"

namespace robochart::frontend {

namespace {

/// A wait of more cycles than this is written as a loop, not as a sequence of `exec`.
constexpr std::int64_t cycles_in_sequence = 3;
/// The largest number of cycles of a wait at a place where a loop is not possible.
constexpr std::int64_t cycles_anywhere = 60;

std::optional<std::int64_t> literal_value(const Expr& expr) {
    if (expr.kind == ExprKind::parenthesised) return literal_value(*expr.args[0]);
    if (expr.kind != ExprKind::integer) return std::nullopt;
    std::int64_t value = 0;
    const char* const end = expr.text.data() + expr.text.size();
    const auto [rest, error] = std::from_chars(expr.text.data(), end, value);
    return error == std::errc() && rest == end ? std::optional(value) : std::nullopt;
}

const Stmt& inside_brackets(const Stmt& statement) {
    const Stmt* inner = &statement;
    while (inner->kind == StmtKind::parenthesised) inner = inner->body[0].get();
    return *inner;
}

}  // namespace

std::string flag_name(const Callers& callers, const std::string& event) {
    std::string name = event + "_free";
    while (callers.variable_of_root(name) != nullptr) name += "_";
    return name;
}

// ---------------------------------------------------------------- expressions

void MachineWriter::need(const Variable& variable) {
    if (callers_.role(machine_, variable) != VariableRole::callers) return;
    const Variable& outer = *callers_.variable_of_root(variable.name);
    const std::string word = outer.kind == DeclKind::constant ? "const" : "var";
    needed_.emplace(variable.name,
                    fmt::format("{} {} : {}", word, robosim_name(outer.name), robosim_text(*outer.type_expr)));
}

/// Records that an operation uses a clock of its caller.
void MachineWriter::need_clock(const Declaration& clock) {
    const bool own = clock.parent == &machine_ || &machine_ == &callers_.root();
    if (!own) needed_.emplace(clock.name, "clock " + robosim_name(clock.name));
}

/// Writes an expression, in which the text `by` replaces the variable `replaced`.
std::string MachineWriter::expression(const Expr& expr, const Variable* replaced, const std::string& by) {
    walk_tree(expr, [&](const Expr& part) {
        if (part.kind == ExprKind::since && part.target != nullptr) need_clock(*part.target);
    });
    return robosim_text(expr, [&](const Expr& name) -> std::string {
        if (name.kind == ExprKind::since_entry) return entry_clocks_.at(name.target);
        const auto* variable = dynamic_cast<const Variable*>(name.target);
        if (variable == nullptr || variable->kind == DeclKind::bound_variable) return "";
        if (variable == replaced) return by;
        if (variable->kind == DeclKind::field) return "";
        need(*variable);
        const bool shared = callers_.role(machine_, *variable) == VariableRole::shared;
        return (shared ? "$" : "") + robosim_name(variable->name);
    });
}

/// Writes `$e?v`, or `$e?$x` if the variable is a register.
std::string MachineWriter::store_text(const Communication& communication) {
    const auto& variable = dynamic_cast<const Variable&>(*communication.variable_target);
    need(variable);
    const bool shared = callers_.role(machine_, variable) == VariableRole::shared;
    return fmt::format("${}?{}{}", robosim_name(communication.event_target->name), shared ? "$" : "",
                       robosim_name(variable.name));
}

/// Returns the new variable for a received value. It is needed if the model does not store the value, but a condition
/// tests it.
std::string MachineWriter::received(const Event& event) {
    const auto [known, added] = received_.try_emplace(event.name);
    if (!added) return known->second;
    known->second = new_variable(event.name + "_value");
    new_lines_.emplace(known->second, fmt::format("var {} : {}", known->second, robosim_text(*event.type_expr)));
    return known->second;
}

/// Returns the variable `e_free` of an input that can be taken twice in a cycle, or "" for other inputs.
std::string MachineWriter::flag(const std::string& event) {
    if (!reusable_.contains(event)) return "";
    const std::string name = flag_name(callers_, event);
    if (&machine_ != &callers_.root()) needed_.emplace(name, fmt::format("var {} : boolean = true", name));
    return name;
}

/// Returns the assignments after the end of a cycle, which record that each input can be taken again.
std::string MachineWriter::reset_text() {
    std::string text;
    for (const std::string& event : reusable_) text += fmt::format("; {} = true", flag(event));
    return text;
}

std::string MachineWriter::cycle_end_text() {
    return "exec" + reset_text();
}

// ---------------------------------------------------------------- simple statements

/// Returns the number of cycles that a time takes, or no value if it is not a literal.
std::optional<std::int64_t> MachineWriter::cycles_of(const Expr& time) const {
    const std::optional<std::int64_t> units = literal_value(time);
    if (component_.cycle == 1) return units;
    const auto cycle = static_cast<std::int64_t>(component_.cycle);
    if (!units || *units % cycle != 0)
        throw NoCyclicForm(time.span, fmt::format("a wait of `{}`", to_text(time)),
                           fmt::format("it may end between two cycles, which take {} time units each", cycle));
    return *units / cycle;
}

/// True if the statement can be written as a statement, with waits of at most this number of cycles.
bool MachineWriter::is_simple(const Stmt& statement, std::int64_t most_cycles) const {
    bool simple = true;
    walk_tree(statement, [&](const Stmt& part) {
        if (part.kind == StmtKind::communication && is_input(*part.communication, false)) simple = false;
        if (part.kind == StmtKind::wait_interval) simple = false;
        if (part.kind != StmtKind::wait) return;
        const std::optional<std::int64_t> cycles = cycles_of(*part.value);
        simple = simple && cycles && *cycles <= most_cycles;
    });
    return simple;
}

void MachineWriter::require_simple(const Stmt& statement, const char* where) const {
    if (is_simple(statement, cycles_anywhere)) return;
    throw NoCyclicForm(
        statement.span, where,
        "it receives an event or waits for a time that is not a number, and actions of RoboSim have no loops");
}

std::string MachineWriter::wait_text(const Stmt& statement) {
    const std::int64_t cycles = *cycles_of(*statement.value);
    if (cycles == 0) return "skip";
    const std::vector<std::string> ends(static_cast<std::size_t>(cycles), cycle_end_text());
    return fmt::format("{}", fmt::join(ends, "; "));
}

std::string MachineWriter::communication_text(const Communication& communication) {
    if (communication.predicate || !communication.from_variable.empty())
        throw NoCyclicForm(communication.span, "a condition on a communication", "RoboSim has no broadcast");
    const std::string name = "$" + robosim_name(communication.event_target->name);
    if (!communication.value) return name;
    const std::string value = expression(*communication.value);
    return name + "!" + (is_closed(*communication.value) ? value : "(" + value + ")");
}

std::string MachineWriter::call_text(const Stmt& statement) {
    const std::string& operation = statement.name.parts.back();
    std::vector<std::string> arguments;
    for (const ExprPtr& argument : statement.args) arguments.push_back(expression(*argument));
    const bool software = callers_.definition(operation) != nullptr;
    return fmt::format("{}{}({})", software ? "" : "$", robosim_name(operation), fmt::join(arguments, ", "));
}

std::string MachineWriter::assignment_text(const Stmt& statement) {
    return fmt::format("{} = {}", expression(*statement.target), expression(*statement.value));
}

/// Returns the longest time that an action takes, or no value if it is unknown.
std::optional<std::int64_t> MachineWriter::longest_time(const Stmt& statement) const {
    switch (statement.kind) {
        case StmtKind::wait:
            return literal_value(*statement.value);
        case StmtKind::wait_interval:
            return literal_value(*statement.upper);
        case StmtKind::communication:
            return is_input(*statement.communication, false) ? std::nullopt : std::optional<std::int64_t>(0);
        case StmtKind::call:
            return callers_.definition(statement.name.parts.back()) != nullptr ? std::nullopt
                                                                               : std::optional<std::int64_t>(0);
        case StmtKind::sequence:
        case StmtKind::parenthesised:
        case StmtKind::deadline:
        case StmtKind::if_then_else: {
            std::int64_t total = 0;
            for (const StmtPtr& part : statement.body) {
                const std::optional<std::int64_t> time = longest_time(*part);
                if (!time) return std::nullopt;
                total += *time;
            }
            return total;
        }
        case StmtKind::skip:
        case StmtKind::assignment:
        case StmtKind::clock_reset:
        case StmtKind::exec:
        case StmtKind::error:
            break;
    }
    return 0;
}

/// Rejects a deadline that may be missed. A deadline has no effect if the action never takes more time, because an
/// output never waits in a model run in cycles.
void MachineWriter::check_deadline(const Stmt& statement) const {
    const std::optional<std::int64_t> time = longest_time(*statement.body[0]);
    const std::optional<std::int64_t> bound = literal_value(*statement.value);
    if (time && (*time == 0 || (bound && *time <= *bound))) return;
    throw NoCyclicForm(statement.span, "a deadline that the action may miss", "RoboSim has no deadlines");
}

std::string MachineWriter::simple_text(const Stmt& statement) {
    switch (statement.kind) {
        case StmtKind::assignment:
            return assignment_text(statement);
        case StmtKind::communication:
            return communication_text(*statement.communication);
        case StmtKind::call:
            return call_text(statement);
        case StmtKind::wait:
            return wait_text(statement);
        case StmtKind::clock_reset:
            if (statement.declaration != nullptr) need_clock(*statement.declaration);
            return "#" + robosim_name(statement.name);
        case StmtKind::deadline:
            check_deadline(statement);
            return simple_text(*statement.body[0]);
        case StmtKind::parenthesised:
            return simple_text(*statement.body[0]);
        case StmtKind::sequence: {
            std::vector<std::string> parts;
            for (const StmtPtr& part : statement.body) parts.push_back(simple_text(*part));
            return fmt::format("{}", fmt::join(parts, "; "));
        }
        case StmtKind::if_then_else:
            return fmt::format("if {} then {}{} end", expression(*statement.condition), simple_text(*statement.body[0]),
                               statement.body.size() > 1 ? " else " + simple_text(*statement.body[1]) : "");
        case StmtKind::skip:
        case StmtKind::wait_interval:
        case StmtKind::exec:
        case StmtKind::error:
            break;
    }
    return "skip";
}

// ---------------------------------------------------------------- statements with junctions

/// Writes the last transition of a path.
void MachineWriter::finish(const Way& way, const std::string& to) {
    std::string text = fmt::format("transition {} {{ from {} to {} {}", way.name, way.from, to, way.begin);
    if (!way.condition.empty()) text += " condition " + way.condition;
    if (!way.actions.empty()) text += fmt::format(" action {}", fmt::join(way.actions, "; "));
    line(text + " }");
}

/// Ends the current transition of a path at a new junction, from which the path continues.
std::string MachineWriter::next_junction(Way& way, const std::string& stem) {
    const std::string junction = new_name(stem);
    line("junction " + junction);
    finish(way, junction);
    way = {junction, new_name(way.name), "", "", {}};
    return junction;
}

void MachineWriter::add_statement(Way& way, const Stmt& statement) {
    if (is_simple(statement, cycles_in_sequence)) {
        way.actions.push_back(simple_text(statement));
        return;
    }
    switch (statement.kind) {
        case StmtKind::deadline:
            check_deadline(statement);
            return add_statement(way, *statement.body[0]);
        case StmtKind::parenthesised:
        case StmtKind::sequence:
            for (const StmtPtr& part : statement.body) add_statement(way, *part);
            return;
        case StmtKind::if_then_else:
            return add_choice(way, statement);
        case StmtKind::wait:
            return add_wait(way, *statement.value, *statement.value);
        case StmtKind::wait_interval:
            return add_wait(way, *statement.value, *statement.upper);
        case StmtKind::communication:
            return add_communication(way, statement);
        case StmtKind::skip:
        case StmtKind::assignment:
        case StmtKind::call:
        case StmtKind::clock_reset:
        case StmtKind::exec:
        case StmtKind::error:
            break;
    }
}

/// Writes `e?x` as a statement: cycles pass until the register contains a value.
void MachineWriter::add_communication(Way& way, const Stmt& statement) {
    const Communication& communication = *statement.communication;
    if (communication.predicate || !communication.from_variable.empty())
        throw NoCyclicForm(communication.span, "a condition on a communication", "RoboSim has no broadcast");
    const std::string& event = communication.event_target->name;
    const std::string free = flag(event);
    const std::string junction = next_junction(way, "await_" + event);
    const std::string absent = "not $" + robosim_name(event);
    line(fmt::format("transition {} {{ from {} to {} condition {} action {} }}", new_name("idle"), junction, junction,
                     free.empty() ? absent : fmt::format("{} \\/ not {}", absent, free), cycle_end_text()));
    way.condition = store_text(communication) + (free.empty() ? "" : " /\\ " + free);
    if (!free.empty()) way.actions.push_back(free + " = false");
}

namespace {

bool has_during_action(const Machine& machine) {
    bool found = false;
    for_states(machine, [&](const State& state) {
        found = found || std::ranges::find(state.actions, ActionKind::during, &Action::kind) != state.actions.end();
    });
    return found;
}

}  // namespace

/// Checks that the time of a wait is a multiple of the cycle, and that it cannot change during the wait.
void MachineWriter::check_time(const Expr& time) const {
    (void)cycles_of(time);
    walk_tree(time, [&](const Expr& part) {
        const auto* variable = dynamic_cast<const Variable*>(part.target);
        if (part.kind != ExprKind::name || variable == nullptr || variable->kind != DeclKind::variable) return;
        if (!has_during_action(callers_.root()) && callers_.role(machine_, *variable) != VariableRole::shared) return;
        throw NoCyclicForm(time.span, fmt::format("a wait of `{}`", to_text(time)),
                           fmt::format("`{}` may change during the wait", variable->name));
    });
}

/// Writes a wait: cycles pass until a clock shows this time. A wait with an interval may end at any time in the
/// interval.
void MachineWriter::add_wait(Way& way, const Expr& least, const Expr& most) {
    check_time(least);
    check_time(most);
    if (clock_.empty()) {
        clock_ = new_variable("waited");
        new_lines_.emplace(clock_, "clock " + clock_);
    }
    way.actions.push_back("#" + clock_);
    const std::string junction = next_junction(way, "waiting");
    line(fmt::format("transition {} {{ from {} to {} condition since({}) < {} action {} }}", new_name("idle"), junction,
                     junction, clock_, expression(most), cycle_end_text()));
    way.condition = fmt::format("since({}) >= {}", clock_, expression(least));
}

void MachineWriter::add_choice(Way& way, const Stmt& statement) {
    const std::string junction = next_junction(way, "choice");
    const std::string condition = expression(*statement.condition);
    const std::string end = new_name("joined");
    line("junction " + end);
    Way taken{junction, way.name, "", condition, {}};
    add_statement(taken, *statement.body[0]);
    finish(taken, end);
    Way other{junction, new_name(way.name), "", fmt::format("not ({})", condition), {}};
    if (statement.body.size() > 1) add_statement(other, inside_brackets(*statement.body[1]));
    finish(other, end);
    way = {end, new_name(way.name), "", "", {}};
}

}  // namespace robochart::frontend
