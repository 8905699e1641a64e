// SPDX-License-Identifier: Apache-2.0
// Writes the declarations, nodes and transitions of a machine.
#include "frontend/cycles/machine_writer.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>

#include "frontend/cycles/copies.hpp"
#include "frontend/names/scopes.hpp"
#include "frontend/syntax/expression_visitor.hpp"
#include "frontend/syntax/print.hpp"

namespace robochart::frontend {

const std::string& interface_of_register(const CyclicComponent& component, const std::string& name) {
    if (!component.usage.written.contains(name)) return component.interfaces.read;
    return component.usage.read.contains(name) ? component.interfaces.both : component.interfaces.written;
}

// ---------------------------------------------------------------- names

/// Returns a name that no node and no transition of the container has.
std::string MachineWriter::new_name(const std::string& stem) {
    std::string name = stem;
    for (std::size_t i = 2; !node_names_.insert(name).second; ++i) name = fmt::format("{}_{}", stem, i);
    return name;
}

std::string MachineWriter::new_variable(const std::string& stem) {
    std::string name = stem;
    for (std::size_t i = 2; !variable_names_.insert(name).second; ++i) name = fmt::format("{}_{}", stem, i);
    return name;
}

void MachineWriter::begin_names(const NodeContainer& container) {
    node_names_.clear();
    for (const auto& node : container.nodes) node_names_.insert(node->name);
    for (const auto& transition : container.transitions) node_names_.insert(transition->name);
}

// ---------------------------------------------------------------- declarations

std::string MachineWriter::write(const std::string& name) {
    const Scope scope = scope_of(machine_);
    const Scope outer = scope_of(callers_.root());
    for (const Scope* known : {&scope, &outer}) {
        for (const auto& [variable, declared] : known->variables) variable_names_.emplace(variable);
        for (const auto& [event, declared] : known->events) variable_names_.emplace(event);
        for (const auto& [clock, declared] : known->clocks) variable_names_.emplace(clock);
        for (const auto& [operation, declared] : known->operations) variable_names_.emplace(operation);
    }
    for (const std::string& event : reusable_) variable_names_.insert(flag_name(callers_, event));
    for (const VariablePtr& parameter : machine_.parameters) variable_names_.insert(parameter->name);
    add_entry_clocks();
    write_container(machine_, {});
    const std::string body = std::move(out_);
    return head(name) + declarations() + body + "}\n";
}

std::string MachineWriter::head(const std::string& name) const {
    if (machine_.kind != DeclKind::operation)
        return fmt::format("stm {} {{\ncycleDef cycle == {}\n", robosim_name(name), component_.cycle);
    std::vector<std::string> parameters;
    for (const VariablePtr& parameter : machine_.parameters)
        parameters.push_back(
            fmt::format("{} : {}", robosim_name(parameter->name), robosim_text(*parameter->type_expr)));
    return fmt::format("operation {}({}) {{\n", robosim_name(name), fmt::join(parameters, ", "));
}

std::string MachineWriter::declarations() {
    const Usage& usage = usage_;
    std::string text;
    const auto add = [&](const std::string& more) { text += more + "\n"; };
    if (machine_.terminates) add("terminates");
    for (const ExprPtr& condition : machine_.preconditions) add("precondition " + expression(*condition));
    for (const ExprPtr& condition : machine_.postconditions) add("postcondition " + expression(*condition));
    if (!usage.software.empty()) add("requires " + component_.interfaces.software);
    if (!usage.constants.empty()) add("requires " + component_.interfaces.constants);
    const bool operation = &machine_ != &callers_.root();
    if (operation && !component_.interfaces.callers.empty()) add("requires " + component_.interfaces.callers);
    text += contexts();
    const auto add_members = [&](const Context& context) {
        for (const VariablePtr& variable : context.variables)
            add(fmt::format("{} {} : {}{}", variable->kind == DeclKind::constant ? "const" : "var",
                            robosim_name(variable->name), robosim_text(*variable->type_expr),
                            variable->initial ? " = " + expression(*variable->initial) : ""));
        for (const auto& clock : context.clocks) add("clock " + robosim_name(clock->name));
    };
    add_members(machine_);
    for (const InterfaceClause& clause : machine_.interfaces)
        if (const Context* used = interface_of(clause); used != nullptr && clause.use == InterfaceUse::uses)
            add_members(*used);
    if (!operation)
        for (const std::string& event : reusable_) add(fmt::format("var {} : boolean = true", flag(event)));
    for (const auto& [name, declared] : new_lines_) add(declared);
    return text;
}

std::string MachineWriter::contexts() const {
    const Usage& usage = usage_;
    std::set<std::string> input, output;
    for (const auto& [name, variable] : usage.read) input.insert(interface_of_register(component_, name));
    for (const auto& [name, variable] : usage.written) output.insert(interface_of_register(component_, name));
    if (!usage.platform.empty()) output.insert(component_.interfaces.platform);
    const auto text = [](const char* word, const auto& events, const std::set<std::string>& interfaces) {
        std::string members;
        for (const auto& [name, event] : events)
            members += fmt::format("event {}{}\n", robosim_name(name),
                                   event->type_expr ? " : " + robosim_text(*event->type_expr) : "");
        for (const std::string& interface : interfaces) members += "requires " + interface + "\n";
        return fmt::format("{} context {{\n{}}}\n", word, members);
    };
    return text("input", usage.inputs, input) + text("output", usage.outputs, output);
}

/// Adds a clock for each state S for which a transition tests `sinceEntry(S)`. Conditions inside S also have to test
/// this time, but `sinceEntry(S)` is not allowed there.
void MachineWriter::add_entry_clocks() {
    for_transitions(machine_, [&](const Transition& transition) {
        if (!transition.condition) return;
        walk_tree(*transition.condition, [&](const Expr& part) {
            if (part.kind != ExprKind::since_entry || entry_clocks_.contains(part.target)) return;
            const std::string clock = new_variable(part.target->name + "_since");
            new_lines_.emplace(clock, "clock " + robosim_name(clock));
            entry_clocks_.emplace(part.target, robosim_name(clock));
        });
    });
}

// ---------------------------------------------------------------- conditions

namespace {

std::vector<const Transition*> ways_from(const NodeContainer& container, const State& node) {
    std::vector<const Transition*> result;
    for (const auto& transition : container.transitions)
        if (transition->source == &node) result.push_back(transition.get());
    return result;
}

bool mentions(const Expr& expr, const Declaration* declared) {
    bool found = false;
    walk_tree(expr, [&](const Expr& part) { found = found || (declared != nullptr && part.target == declared); });
    return found;
}

bool has_exit_action(const Machine& machine) {
    bool found = false;
    for_states(machine, [&](const State& state) {
        found = found || std::ranges::find(state.actions, ActionKind::exit, &Action::kind) != state.actions.end();
    });
    return found;
}

std::string conjunction(const std::string& a, const std::string& b) {
    if (a.empty() || b.empty()) return a + b;
    return a + " /\\ " + b;
}

}  // namespace

/// True if the condition of a transition tests the value that its trigger receives.
bool MachineWriter::tests_value(const Transition& transition) const {
    return transition.trigger && transition.condition &&
           mentions(*transition.condition, transition.trigger->variable_target);
}

/// Returns the condition of a transition, with the received value replaced by the variable `by`.
std::string MachineWriter::tested_value(const Transition& transition, const std::string& by) {
    const auto* variable = dynamic_cast<const Variable*>(transition.trigger->variable_target);
    return expression(*transition.condition, variable, by);
}

void MachineWriter::check_trigger(const Communication& trigger) const {
    const bool receives = trigger.kind == CommKind::input || trigger.kind == CommKind::simple;
    if (trigger.predicate || !trigger.from_variable.empty() || !receives)
        throw NoCyclicForm(trigger.span, fmt::format("trigger `{}`", to_text(trigger)),
                           "in RoboSim, an input has no condition on its sender and no given value");
}

/// Returns the condition under which a transition is taken, including the parts that store received values. The result
/// is "" if it is always taken.
std::string MachineWriter::taken_condition(const Transition& transition) {
    if (!transition.trigger) return transition.condition ? expression(*transition.condition) : "";
    const Communication& trigger = *transition.trigger;
    check_trigger(trigger);
    const auto& event = dynamic_cast<const Event&>(*trigger.event_target);
    const std::string free = flag(event.name);
    std::string text = "$" + robosim_name(event.name);
    if (tests_value(transition)) {
        const auto& variable = dynamic_cast<const Variable&>(*trigger.variable_target);
        const bool shared = callers_.role(machine_, variable) == VariableRole::shared;
        if (shared && has_exit_action(machine_))
            throw NoCyclicForm(trigger.span, fmt::format("trigger `{}`", to_text(trigger)),
                               fmt::format("its condition tests the value of `{}`, which is shared, and states have "
                                           "exit actions, which come after its change",
                                           variable.name));
        const std::string name = shared ? received(event) : robosim_name(variable.name);
        text =
            fmt::format("{} : ({})", shared ? text + "?" + name : store_text(trigger), tested_value(transition, name));
    } else {
        if (trigger.kind == CommKind::input) text = store_text(trigger);
        if (transition.condition) text = conjunction(text, "(" + expression(*transition.condition) + ")");
    }
    return conjunction(text, free);
}

/// Returns the condition under which a transition is not enabled. It is the negation of `taken_condition`, without the
/// parts that store values in variables of the model.
std::string MachineWriter::rest_condition(const Transition& transition) {
    if (!transition.trigger) return fmt::format("not ({})", expression(*transition.condition));
    const auto& event = dynamic_cast<const Event&>(*transition.trigger->event_target);
    const std::string free = flag(event.name);
    const std::string read = "$" + robosim_name(event.name);
    std::vector<std::string> parts{"not " + read};
    if (tests_value(transition)) {
        const std::string value = received(event);
        parts.push_back(fmt::format("{}?{} : (not ({}))", read, value, tested_value(transition, value)));
    } else if (transition.condition) {
        parts.push_back(fmt::format("not ({})", expression(*transition.condition)));
    }
    if (!free.empty()) parts.push_back("not " + free);
    const std::string text = fmt::format("{}", fmt::join(parts, " \\/ "));
    return parts.size() == 1 ? text : "(" + text + ")";
}

/// Returns the condition under which no transition is enabled, and no during action runs.
std::string MachineWriter::idle_condition(const Surroundings& inside) {
    std::vector<std::string> parts;
    const auto add = [&](const std::string& part) {
        if (std::ranges::find(parts, part) == parts.end()) parts.push_back(part);
    };
    for (const std::string& busy : inside.busy) add("not " + busy);
    for (const Transition* transition : inside.outgoing) add(rest_condition(*transition));
    return fmt::format("{}", fmt::join(parts, " /\\ "));
}

// ---------------------------------------------------------------- nodes

void MachineWriter::write_container(const NodeContainer& container, const Surroundings& around) {
    begin_names(container);
    for (const auto& node : container.nodes) {
        const std::set<std::string> names = node_names_;
        write_node(container, *node, around);
        node_names_ = names;
    }
    for (const auto& node : container.nodes) {
        if (node->kind != DeclKind::initial || around.first.empty()) continue;
        const std::string start = new_name("start");
        line("initial " + start);
        Way way{start, new_name("begin"), "", "", {}};
        for (const Stmt* statement : around.first) add_statement(way, *statement);
        finish(way, robosim_name(node->name));
    }
    for (const auto& transition : container.transitions) write_transition(*transition, around);
    for (const auto& node : container.nodes)
        if (node->kind == DeclKind::junction) write_blocked(container, *node, around);
}

/// In RoboChart, time passes at a junction while no transition is enabled. In RoboSim, time would stop there. So cycles
/// pass, unless a transition is certainly enabled.
void MachineWriter::write_blocked(const NodeContainer& container, const State& junction, const Surroundings& around) {
    const Surroundings leaving{nullptr, ways_from(container, junction), around.busy, {}, {}};
    std::set<std::string> conditions;
    for (const Transition* transition : leaving.outgoing) {
        if (transition->otherwise || !transition->condition) return;
        conditions.insert(expression(*transition->condition));
    }
    for (const std::string& condition : conditions)
        if (conditions.contains("not " + condition) || conditions.contains("not (" + condition + ")")) return;
    if (conditions.empty()) return;
    line(fmt::format("transition {0} {{ from {1} to {1} condition {2} action {3} }}", new_name("blocked"),
                     robosim_name(junction.name), idle_condition(leaving), cycle_end_text()));
}

void MachineWriter::write_node(const NodeContainer& container, const State& node, const Surroundings& around) {
    const std::string name = robosim_name(node.name);
    switch (node.kind) {
        case DeclKind::initial:
            return line((around.first.empty() ? "initial " : "junction ") + name);
        case DeclKind::junction:
            return line("junction " + name);
        case DeclKind::probabilistic:
            return line("probabilistic " + name);
        case DeclKind::final:
            if (around.state == nullptr) return line("final " + name);
            break;
        default:
            break;
    }
    write_state(container, node, around);
}

namespace {

bool may_wait(const Stmt& action, const Callers& callers);

/// Collects the statements of an action in order, without the parentheses and deadlines around them.
void flatten_action(const Stmt& statement, std::vector<const Stmt*>& parts) {
    if (statement.kind != StmtKind::sequence && statement.kind != StmtKind::parenthesised) {
        parts.push_back(&statement);
        return;
    }
    for (const StmtPtr& part : statement.body) flatten_action(*part, parts);
}

}  // namespace

/// Writes a state. A final state in a composite state also becomes a state, in which cycles pass.
void MachineWriter::write_state(const NodeContainer& container, const State& state, const Surroundings& around) {
    Surroundings inside{&state, ways_from(container, state), around.busy, {}, {}};
    inside.outgoing.insert(inside.outgoing.end(), around.outgoing.begin(), around.outgoing.end());
    std::vector<const Stmt*> entry;
    std::vector<std::string> first, exit;
    std::string during;
    for (const Action& action : state.actions) {
        if (!action.statement) continue;
        if (action.kind == ActionKind::entry) flatten_action(*action.statement, entry);
        if (action.kind == ActionKind::exit) {
            require_simple(*action.statement, "an exit action");
            exit.push_back(simple_text(*action.statement));
        }
        if (action.kind != ActionKind::during) continue;
        const std::string busy = new_variable(state.name + "_busy");
        new_lines_.emplace(busy, fmt::format("var {} : boolean = false", busy));
        inside.busy.push_back(busy);
        during = during_text(state, busy);
        first.push_back(busy + " = true");
    }
    auto statement = entry.begin();
    for (; statement != entry.end() && is_simple(**statement, 3); ++statement)
        first.push_back(simple_text(**statement));
    inside.first.assign(statement, entry.end());
    if (const auto clock = entry_clocks_.find(&state); clock != entry_clocks_.end()) {
        bool waits = !inside.first.empty();
        for_actions(state, [&](const Stmt& inner) { waits = waits || may_wait(inner, callers_); });
        if (waits && !state.nodes.empty())
            throw NoCyclicForm(state.name_span, fmt::format("`sinceEntry({})`", state.name),
                               "actions inside the state wait, and the state counts as entered only after the first");
        first.push_back("#" + clock->second);
        inside.entry_clock = clock->second;
    }
    line(fmt::format("state {} {{", robosim_name(state.name)));
    if (!first.empty()) line(fmt::format("entry {}", fmt::join(first, "; ")));
    if (!during.empty()) line("during " + during);
    if (!exit.empty()) line(fmt::format("exit {}", fmt::join(exit, "; ")));
    if (state.nodes.empty())
        write_rest(inside);
    else
        write_container(state, inside);
    line("}");
}

/// Writes the contents of a state without inner nodes, in which cycles pass while no transition is enabled.
void MachineWriter::write_rest(const Surroundings& inside) {
    const bool moves_on = inside.busy.empty() && std::ranges::any_of(inside.outgoing, [](const Transition* transition) {
                              return !transition->trigger && !transition->condition;
                          });
    if (moves_on && inside.first.empty()) return;
    node_names_.clear();
    const std::string start = new_name("start"), rest = new_name("Resting");
    line("initial " + start);
    line(fmt::format("state {} {{}}", rest));
    Way way{start, new_name("begin"), "", "", {}};
    for (const Stmt* statement : inside.first) add_statement(way, *statement);
    if (!inside.first.empty() && !inside.entry_clock.empty()) way.actions.push_back("#" + inside.entry_clock);
    finish(way, rest);
    const bool never = std::ranges::any_of(
        inside.outgoing, [](const Transition* transition) { return !transition->trigger && !transition->condition; });
    if (never) return;
    const std::string condition = idle_condition(inside);
    const std::string resets = reset_text();
    line(fmt::format("transition {} {{ from {} to {} exec{}{} }}", new_name("idle"), rest, rest,
                     condition.empty() ? "" : " condition " + condition,
                     resets.empty() ? "" : " action " + resets.substr(2)));
}

namespace {

/// True if an operation certainly ends without time passing and without an input.
bool takes_no_time(const Machine& operation, const Callers& callers);

/// True if an action may end a cycle.
bool may_wait(const Stmt& action, const Callers& callers) {
    bool waits = false;
    walk_tree(action, [&](const Stmt& part) {
        if (part.kind == StmtKind::wait || part.kind == StmtKind::wait_interval) waits = true;
        if (part.kind == StmtKind::communication && is_input(*part.communication, false)) waits = true;
        if (part.kind != StmtKind::call) return;
        const Machine* const definition = callers.definition(part.name.parts.back());
        waits = waits || (definition != nullptr && !takes_no_time(*definition, callers));
    });
    return waits;
}

bool takes_no_time(const Machine& operation, const Callers& callers) {
    bool instant = true;
    for_actions(operation, [&](const Stmt& action) { instant = instant && !may_wait(action, callers); });
    walk_tree(operation, [&](const NodeContainer& container) {
        for (const auto& node : container.nodes) {
            const auto ways = ways_from(container, *node);
            const bool rests = node->kind == DeclKind::state;
            instant = instant && (!rests || std::ranges::any_of(ways, [](const Transition* way) {
                          return !way->trigger && !way->condition;
                      }));
        }
        for (const auto& transition : container.transitions) instant = instant && !transition->trigger;
    });
    return instant;
}

}  // namespace

/// Returns the during action. At its end it sets the variable `busy` to false, because the cycle may only end then.
std::string MachineWriter::during_text(const State& state, const std::string& busy) {
    std::string text;
    for (const Action& action : state.actions) {
        if (action.kind != ActionKind::during || !action.statement) continue;
        if (may_wait(*action.statement, callers_))
            throw NoCyclicForm(
                action.span, fmt::format("the during action of state `{}`", state.name),
                "it waits or receives an event, and other actions that run at the same time end cycles, too");
        bool inner_waits = false;
        for_actions(state, [&](const Stmt& inner) { inner_waits = inner_waits || may_wait(inner, callers_); });
        if (inner_waits)
            throw NoCyclicForm(action.span, fmt::format("the during action of state `{}`", state.name),
                               "actions of inner states end cycles, perhaps before it has ended");
        text += simple_text(*action.statement) + "; ";
    }
    return text + busy + " = false";
}

// ---------------------------------------------------------------- transitions

namespace {

/// Returns the time at which the value of a comparison of a clock with a number `n` changes. It changes once: at `n`,
/// or one time unit later.
std::optional<std::int64_t> time_of_change(const Expr& comparison) {
    if (comparison.kind != ExprKind::binary || comparison.args[1]->kind != ExprKind::integer) return std::nullopt;
    const ExprKind left = comparison.args[0]->kind;
    if (left != ExprKind::since && left != ExprKind::since_entry) return std::nullopt;
    const std::int64_t number = std::stoll(comparison.args[1]->text.substr(0, 9));
    switch (*comparison.binary) {
        case BinaryOp::greater_equal:
        case BinaryOp::less:
            return number;
        case BinaryOp::greater:
        case BinaryOp::less_equal:
            return number + 1;
        default:
            return std::nullopt;
    }
}

}  // namespace

/// Checks that the condition of a transition without trigger becomes true only at the beginning of a cycle, because
/// such a transition is taken as soon as its condition holds.
void MachineWriter::check_times(const Transition& transition) const {
    if (component_.cycle == 1 || transition.trigger || !transition.condition) return;
    std::size_t clocks = 0, checked = 0;
    walk_tree(*transition.condition, [&](const Expr& part) {
        if (part.kind == ExprKind::since || part.kind == ExprKind::since_entry) ++clocks;
        const std::optional<std::int64_t> time = time_of_change(part);
        if (time && *time % component_.cycle == 0) ++checked;
    });
    if (clocks == checked) return;
    throw NoCyclicForm(
        transition.condition->span, fmt::format("the condition of transition `{}`", transition.name),
        fmt::format("it may change between two cycles, which take {} time units each", component_.cycle));
}

void MachineWriter::write_transition(const Transition& transition, const Surroundings&) {
    if (transition.deadline)
        throw NoCyclicForm(transition.deadline->span, fmt::format("the deadline of transition `{}`", transition.name),
                           "RoboSim has no deadlines");
    check_times(transition);
    Way way{robosim_name(transition.from), robosim_name(transition.name), "", "", {}};
    if (transition.probability) way.begin += "probability " + expression(*transition.probability) + " ";
    for (const Transition::Reset& reset : transition.resets) way.begin += "#" + robosim_name(reset.name) + " ";
    way.condition = transition.otherwise ? "else" : taken_condition(transition);
    if (transition.trigger) {
        const Communication& trigger = *transition.trigger;
        const std::string free = flag(trigger.event_target->name);
        if (!free.empty()) way.actions.push_back(free + " = false");
        const auto* variable = dynamic_cast<const Variable*>(trigger.variable_target);
        if (tests_value(transition) && callers_.role(machine_, *variable) == VariableRole::shared)
            way.actions.push_back(fmt::format("${} = {}", robosim_name(variable->name),
                                              received(dynamic_cast<const Event&>(*trigger.event_target))));
    }
    if (transition.action) add_statement(way, *transition.action);
    finish(way, robosim_name(transition.to));
}

}  // namespace robochart::frontend
