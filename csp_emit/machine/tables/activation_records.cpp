// SPDX-License-Identifier: Apache-2.0
// Opens frames. An operation shares the elements that it requires with its caller. Its other elements get new cells.
#include "csp_emit/machine/tables/activation_records.hpp"

#include <algorithm>
#include <set>
#include <string>

#include "checker/cspm/syntax/build.hpp"
#include "csp_emit/base/rules.hpp"
#include "semantics/evaluate/preconditions.hpp"

namespace robochart::csp_emit {

namespace b = cspm::build;
using cspm::ExprPtr;

namespace {

/// Returns the index of the element with this name, if it exists.
template <class Element>
std::optional<std::size_t> find_named(const std::vector<Element>& elements, const std::string& name) {
    const auto found = std::ranges::find_if(elements, [&](const Element& e) { return e.name == name; });
    if (found == elements.end()) return std::nullopt;
    return static_cast<std::size_t>(found - elements.begin());
}

/// Returns a text for the caller's element with this name, or "-" if the caller has none.
template <class Element, class Meaning>
std::string bound_to(const std::vector<Element>& elements, const std::string& name, const Meaning& meaning) {
    const auto found = find_named(elements, name);
    return found ? meaning(*found) : "-";
}

/// True if a guard of the machine reads the clock.
bool reads_clock(const ir::Machine& machine, std::uint32_t clock) {
    const auto uses = [&](const ir::Expr& part) {
        if (part.kind == ir::ExprKind::since) return part.clock.index == clock;
        return part.kind == ir::ExprKind::since_entry && machine.clocks[clock].entry_of == part.node;
    };
    return std::ranges::any_of(machine.transitions,
                               [&](const ir::Transition& t) { return t.guard && has_part(*t.guard, uses); });
}

}  // namespace

bool is_callers(const ir::Machine& machine, const ir::Clock& clock) {
    return machine.kind == ir::MachineKind::operation && clock.required;
}

ActivationRecords::ActivationRecords(const MachineContext& context, const CallGraph& calls, ParameterTable& cells,
                                     ClockLimits& limits)
    : context_(context), calls_(calls), cells_(cells), limits_(limits) {
    open_frame(*context.machine, 0, "");
}

std::uint32_t ActivationRecords::open_frame(const ir::Machine& opened, std::uint32_t parent,
                                            const std::string& prefix) {
    const bool root = frames_.empty();
    Frame frame;
    frame.machine = &opened;
    frame.parent = parent;
    frame.prefix = prefix;
    add_variables(frame, root);
    add_constants(frame);
    add_events(frame, root);
    if (project().is_timed()) {
        add_clocks(frame, root);
        add_monitors(frame);
    } else {
        frame.clocks.resize(opened.clocks.size());
    }
    find_watched(frame, root);
    frames_.push_back(std::move(frame));
    return static_cast<std::uint32_t>(frames_.size() - 1);
}

/// Adds cells for the variables. A machine may have several own variables with the same name, which may also be the
/// name of a shared variable. The shared variable has RoboTool's channels, and the own variables have other channels.
void ActivationRecords::add_variables(Frame& frame, bool root) {
    std::set<std::string> channels;
    for (const ir::Variable& variable : frame.machine->variables)
        if (variable.scope == ir::VariableScope::required) channels.insert(variable.name);
    for (const ir::Variable& variable : frame.machine->variables) {
        const bool callers = variable.scope == ir::VariableScope::required || variable.scope == ir::VariableScope::reg;
        if (!root && callers) {
            const Frame& caller = frames_[frame.parent];
            const auto found = find_named(caller.machine->variables, variable.name);
            if (!found)
                project().diagnostics.report(rules::missing_in_caller, frame.machine->origin.span,
                                             {frame.machine->name, "variable", variable.name, caller.machine->name});
            if (found) {
                frame.variables.push_back(caller.variables[*found]);
                continue;
            }
        }
        Cell cell;
        cell.name = "v_" + frame.prefix + variable.name;
        cell.meaning = frame.prefix.empty() ? variable.name : frame.machine->name + "::" + variable.name;
        cell.type = variable.type;
        cell.shared = root && variable.scope == ir::VariableScope::required;
        cell.parameter = variable.scope == ir::VariableScope::parameter;
        cell.channel = variable.name;
        if (variable.scope == ir::VariableScope::reg) {
            cell.name = "v_" + frame.prefix + flatten_name(variable.name);
            cell.channel = flatten_name(variable.name);
            if (variable.output) cell.output = "o_" + variable.name.substr(1);
        }
        while (variable.scope != ir::VariableScope::required && !channels.insert(cell.channel).second)
            cell.channel += "_";
        frame.variables.push_back(cells_.add_cell(std::move(cell)));
        frame.own.push_back(frame.variables.back());
    }
}

void ActivationRecords::add_clocks(Frame& frame, bool root) {
    const bool all_announced = project().blocks_mention("clockReset") || project().blocks_mention("FVS_C__");
    for (std::uint32_t i = 0; i < frame.machine->clocks.size(); ++i) {
        const ir::Clock& clock = frame.machine->clocks[i];
        frame.announced.emplace_back();
        if (!root && clock.required) {
            const Frame& caller = frames_[frame.parent];
            if (const auto found = find_named(caller.machine->clocks, clock.name)) {
                frame.clocks.push_back(caller.clocks[*found]);
                frame.announced.back() = caller.announced[*found];
                continue;
            }
        }
        const bool outside = root && is_callers(*context_.machine, clock);
        if (outside || (root && all_announced && !clock.entry_of.is_valid()))
            frame.announced.back() = "CLID_" + flatten_name(clock.name);
        add_clock(frame, {i}, outside);
    }
}

/// Adds a cell for the clock if a guard reads it. If `outside` is true, the clock belongs to the caller, so an event
/// reads it.
void ActivationRecords::add_clock(Frame& frame, ir::ClockId id, bool outside) {
    const ir::Machine& opened = *frame.machine;
    const ir::Clock& clock = opened.clocks[id.index];
    if (!read_somewhere(opened, id)) {
        frame.clocks.push_back(std::nullopt);
        return;
    }
    Cell cell;
    cell.kind = CellKind::clock;
    cell.name = "c_" + frame.prefix + clock.name;
    cell.meaning = clock.entry_of.is_valid() ? "sinceEntry(" + opened.nodes[clock.entry_of.index].path + ")"
                                             : "since(" + clock.name + ")";
    cell.limit = limits_.limit_of(opened, clock.name, clock.entry_of);
    if (outside) cell.reading = "get_CLID_" + flatten_name(clock.name);
    frame.clocks.push_back(cells_.add_cell(std::move(cell)));
    if (!outside) frame.own.push_back(*frame.clocks.back());
}

/// True if the machine reads its clock, or may call an operation that requires and reads the clock.
bool ActivationRecords::read_somewhere(const ir::Machine& opened, ir::ClockId id) const {
    const auto below = calls_.callable_operations();
    const auto inherits = [&](const ir::Machine* operation) {
        const auto found = find_named(operation->clocks, opened.clocks[id.index].name);
        return found && operation->clocks[*found].required &&
               reads_clock(*operation, static_cast<std::uint32_t>(*found));
    };
    return reads_clock(opened, id.index) || std::ranges::any_of(below, inherits);
}

void ActivationRecords::add_constants(Frame& frame) const {
    for (const ConstantParameter& constant : calls_.constants())
        if (constant.owner == frame.machine) {
            frame.constants.resize(std::max<std::size_t>(frame.constants.size(), constant.id.index + 1));
            frame.constants[constant.id.index] = b::name(constant.inside);
        }
}

void ActivationRecords::add_events(Frame& frame, bool root) const {
    const ir::Machine& machine = *context_.machine;
    for (const ir::Event& event : frame.machine->events) {
        frame.events.push_back(event.name);
        if (root || find_named(machine.events, event.name)) continue;
        project().diagnostics.report(rules::missing_in_caller, frame.machine->origin.span,
                                     {frame.machine->name, "event", event.name, machine.name});
    }
}

void ActivationRecords::add_monitors(Frame& frame) {
    for (std::uint32_t i = 0; i < frame.machine->transitions.size(); ++i) {
        const ir::Transition& transition = frame.machine->transitions[i];
        if (!transition.deadline) continue;
        const auto outside = [&](const ir::Expr& part) {
            if (part.kind != ir::ExprKind::since || !frame.clocks.at(part.clock.index)) return false;
            return !cells_[*frame.clocks[part.clock.index]].reading.empty();
        };
        if (transition.guard && has_part(*transition.guard, outside))
            project().report_unsupported(
                "the deadline of " + transition.name + " under a condition on the caller's clock",
                transition.origin.span);
        // no document on the semantics defines whether such a deadline runs
        if (ir::preconditions_can_fail(project().system, project().instantiation, {}, *transition.deadline))
            project().report_unsupported("the deadline of " + transition.name + " by a function with a precondition",
                                         transition.origin.span);
        Cell cell;
        cell.kind = CellKind::monitor;
        cell.name = "m_" + frame.prefix + transition.name;
        cell.meaning = "time left for " + transition.name;
        cell.deadline = transition.origin;
        frame.monitors[i] = cells_.add_cell(std::move(cell));
    }
}

void ActivationRecords::find_watched(Frame& frame, bool root) const {
    if (context_.watched.empty()) return;
    const auto& clocks = frame.machine->clocks;
    for (std::uint32_t i = 0; i < clocks.size(); ++i) {
        const bool callers = clocks[i].required && !root && frames_[frame.parent].watched;
        if (clocks[i].name == context_.watched && !clocks[i].entry_of.is_valid() && (root || callers))
            frame.watched = ir::ClockId{i};
    }
}

std::uint32_t ActivationRecords::frame_of_call(std::uint32_t caller, const ir::Stmt& call,
                                               const ir::Machine& operation) {
    const auto key = std::make_pair(caller, &call);
    if (const auto found = called_.find(key); found != called_.end()) return found->second;
    // with the names of all callers as prefixes, deep chains of calls would make the size of the script quadratic
    constexpr std::size_t longest = 40;
    const std::string& above = frames_[caller].prefix;
    const std::string prefix = (above.size() < longest ? above : "") + operation.name + "_";
    return called_[key] = open_frame(operation, caller, prefix);
}

std::uint32_t ActivationRecords::shared_frame(std::uint32_t caller, const ir::Machine& operation) {
    const Frame& outer = frames_[caller];
    std::string key = operation.package + "::" + operation.path + (outer.watched ? " watched" : "");
    for (const ir::Variable& variable : operation.variables)
        if (variable.scope == ir::VariableScope::required)
            key += " " + bound_to(outer.machine->variables, variable.name,
                                  [&](std::size_t i) { return std::to_string(outer.variables[i]); });
    for (const ir::Clock& clock : operation.clocks)
        if (clock.required && project().is_timed())
            key += " " + bound_to(outer.machine->clocks, clock.name, [&](std::size_t i) {
                       const std::string cell = outer.clocks[i] ? std::to_string(*outer.clocks[i]) : "unread";
                       return cell + outer.announced[i];
                   });
    if (const auto found = shared_.find(key); found != shared_.end()) return found->second;
    return shared_[key] = open_frame(operation, caller, operation.name + "_");
}

Scope ActivationRecords::make_scope(std::uint32_t index, const Values& values, ExprPtr trigger_value) const {
    Scope result;
    // a scope may outlive the values from which it was constructed
    const auto values_now = std::make_shared<const Values>(values);
    result.variable = [this, index, values_now](ir::VariableId id) {
        return cells_.current_value(frames_[index].variables.at(id.index), *values_now);
    };
    result.constant = [this, index](ir::ConstantId id) { return frames_[index].constants.at(id.index); };
    result.clock = [this, index, values_now](ir::ClockId id) {
        return cells_.current_value(frames_[index].clocks.at(id.index).value(), *values_now);
    };
    result.entry_clock = [this, index, values_now](ir::NodeId node) {
        const auto& clocks = frames_[index].machine->clocks;
        const auto found = std::ranges::find_if(clocks, [&](const auto& c) { return c.entry_of == node; });
        const auto number = static_cast<std::size_t>(found - clocks.begin());
        return cells_.current_value(frames_[index].clocks.at(number).value(), *values_now);
    };
    result.trigger_value = std::move(trigger_value);
    return result;
}

const ir::Machine* ActivationRecords::find_definition(std::uint32_t frame, ir::OperationId operation) const {
    return calls_.find_definition(*frames_[frame].machine, operation);
}

const std::string* ActivationRecords::reset_constructor(std::uint32_t frame, ir::ClockId clock) const {
    const auto& names = frames_[frame].announced;
    return clock.index < names.size() && !names[clock.index].empty() ? &names[clock.index] : nullptr;
}

ExprPtr ActivationRecords::full_time(CellId cell, const Values& values) const {
    for (std::uint32_t index = 0; index < frames_.size(); ++index)
        for (const auto& [id, monitor] : frames_[index].monitors)
            if (monitor == cell)
                return translate_expression(project(), make_scope(index, values),
                                            *frames_[index].machine->transitions[id].deadline);
    return b::number(0);
}

const ir::Stmt* ActivationRecords::reset_statement(std::uint32_t frame, ir::TransitionId id, ir::ClockId clock) {
    const auto [found, added] = reset_statements_.try_emplace({frame, id.index, clock.index});
    if (added) {
        const ir::Machine& owner = *frames_[frame].machine;
        found->second.kind = ir::StmtKind::clock_reset;
        found->second.clock = clock;
        found->second.origin = owner.transitions[id.index].origin;
        const auto clocks = static_cast<std::uint32_t>(owner.clocks.size());
        // The clock belongs to a called operation.
        found->second.point = owner.points + id.index * clocks + clock.index;
    }
    return &found->second;
}

}  // namespace robochart::csp_emit
