// Machines and called operations: which parameter holds which variable, clock and counter.
// An operation works on its caller's variables, clocks and events of the same name (semantics 3.8).
#include <algorithm>

#include "checker/cspm/syntax/build.hpp"
#include "csp_emit/machine/machine.hpp"
#include "csp_emit/base/rules.hpp"
#include "csp_emit/base/types.hpp"
#include "semantics/ir/query.hpp"
#include "semantics/evaluate/preconditions.hpp"

namespace robochart::csp_emit {

namespace b = cspm::build;
using cspm::ExprPtr;

namespace {

/// Index of the element of that name, if there is one.
template <class Element>
std::optional<std::size_t> find_named(const std::vector<Element>& elements, const std::string& name) {
    const auto found = std::find_if(elements.begin(), elements.end(), [&](const Element& e) { return e.name == name; });
    if (found == elements.end()) return std::nullopt;
    return static_cast<std::size_t>(found - elements.begin());
}

/// Whether a guard of the machine reads the clock.
bool reads_clock(const ir::Machine& machine, std::uint32_t clock) {
    const auto uses = [&](const ir::Expr& part) {
        if (part.kind == ir::ExprKind::since) return part.clock.index == clock;
        return part.kind == ir::ExprKind::since_entry && machine.clocks[clock].entry_of == part.node;
    };
    return std::any_of(machine.transitions.begin(), machine.transitions.end(),
                       [&](const ir::Transition& t) { return t.guard && mentions(*t.guard, uses); });
}

}  // namespace

CellId MachineEmitter::add_cell(Cell cell) {
    cell.name = context_.names.unique(cell.name);
    cell_named_[cell.name] = static_cast<CellId>(cells_.size());
    cells_.push_back(std::move(cell));
    return static_cast<CellId>(cells_.size() - 1);
}

std::uint32_t MachineEmitter::open_frame(const ir::Machine& opened, std::uint32_t parent, const std::string& prefix) {
    const bool root = frames_.empty();
    Frame frame;
    frame.machine = &opened;
    frame.parent = parent;
    frame.prefix = prefix;
    add_variables(frame, root);
    add_constants(frame);
    add_events(frame, root);
    if (timed()) {
        add_clocks(frame, root);
        add_monitors(frame);
    } else {
        frame.clocks.resize(opened.clocks.size());
    }
    add_watch(frame, root);
    find_races(frame);
    frames_.push_back(std::move(frame));
    return static_cast<std::uint32_t>(frames_.size() - 1);
}

void MachineEmitter::add_variables(Frame& frame, bool root) {
    for (const ir::Variable& variable : frame.machine->variables) {
        if (!root && variable.scope == ir::VariableScope::required) {
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
        frame.variables.push_back(add_cell(cell));
        frame.own.push_back(frame.variables.back());
    }
}

/// Whether the clock is that of the caller, and this is the operation on its own.
bool MachineEmitter::is_callers(const ir::Clock& clock) const {
    return machine().kind == ir::MachineKind::operation && clock.required;
}

/// The constructor of the event clockReset that a reset of the clock is; null if it is no event.
const std::string* MachineEmitter::announced(std::uint32_t frame, ir::ClockId clock) const {
    const auto& names = frames_[frame].announced;
    return clock.index < names.size() && !names[clock.index].empty() ? &names[clock.index] : nullptr;
}

void MachineEmitter::add_clocks(Frame& frame, bool root) {
    const ir::Machine& opened = *frame.machine;
    const auto below = callable();
    const bool all_announced = project().mentions("clockReset") || project().mentions("FVS_C__");
    for (std::uint32_t i = 0; i < opened.clocks.size(); ++i) {
        const ir::Clock& clock = opened.clocks[i];
        frame.announced.emplace_back();
        if (!root && clock.required) {
            const Frame& caller = frames_[frame.parent];
            if (const auto found = find_named(caller.machine->clocks, clock.name)) {
                frame.clocks.push_back(caller.clocks[*found]);
                frame.announced.back() = caller.announced[*found];
                continue;
            }
        }
        const bool outside = root && is_callers(clock);
        if (outside || (root && all_announced && !clock.entry_of.valid()))
            frame.announced.back() = "CLID_" + flatten(clock.name);
        const auto inherits = [&](const ir::Machine* operation) {
            const auto found = find_named(operation->clocks, clock.name);
            return found && operation->clocks[*found].required &&
                   reads_clock(*operation, static_cast<std::uint32_t>(*found));
        };
        if (!reads_clock(opened, i) && std::none_of(below.begin(), below.end(), inherits)) {
            frame.clocks.push_back(std::nullopt);
            continue;
        }
        Cell cell;
        cell.kind = CellKind::clock;
        cell.name = "c_" + frame.prefix + clock.name;
        cell.meaning = clock.entry_of.valid() ? "sinceEntry(" + opened.nodes[clock.entry_of.index].path + ")"
                                              : "since(" + clock.name + ")";
        cell.limit = clock_limit(opened, clock.name, clock.entry_of);
        if (outside) cell.reading = "get_CLID_" + flatten(clock.name);
        frame.clocks.push_back(add_cell(cell));
        if (!outside) frame.own.push_back(*frame.clocks.back());
    }
}

void MachineEmitter::add_constants(Frame& frame) {
    for (const ConstantParameter& constant : constants_)
        if (constant.owner == frame.machine) frame.constants.push_back(b::name(constant.inside));
}

/// The machine's constants in order of declaration, then those of the operations it calls (semantics 3.12).
void MachineEmitter::collect_constants(const ir::Machine& owner) {
    if (std::find(reached_.begin(), reached_.end(), &owner) != reached_.end()) return;
    reached_.push_back(&owner);
    for (std::uint32_t i = 0; i < owner.constants.size(); ++i) {
        const std::string name = ir::constant_name(owner.package, owner.path, owner.constants[i].name);
        constants_.push_back({name,
                              owner.constants[i].name,
                              name,
                              &owner,
                              {i},
                              owner.constants[i].type,
                              context_.names.unique(flatten(owner.constants[i].name))});
    }
    for (const ir::OperationId called : ir::called_operations(owner)) {
        const auto found = context_.definitions.find(owner.operations[called.index].name);
        if (found != context_.definitions.end()) collect_constants(project().system.machine(found->second));
    }
}

void MachineEmitter::add_events(Frame& frame, bool root) {
    for (const ir::Event& event : frame.machine->events) {
        frame.events.push_back(event.name);
        if (root || find_named(machine().events, event.name)) continue;
        project().diagnostics.report(rules::missing_in_caller, frame.machine->origin.span,
                                     {frame.machine->name, "event", event.name, machine().name});
    }
}

void MachineEmitter::add_monitors(Frame& frame) {
    for (std::uint32_t i = 0; i < frame.machine->transitions.size(); ++i) {
        const ir::Transition& transition = frame.machine->transitions[i];
        if (!transition.deadline) continue;
        const auto outside = [&](const ir::Expr& part) {
            if (part.kind != ir::ExprKind::since || !frame.clocks.at(part.clock.index)) return false;
            return !cells_[*frame.clocks[part.clock.index]].reading.empty();
        };
        if (transition.guard && mentions(*transition.guard, outside))
            project().refuse("the deadline of " + transition.name + " under a condition on the caller's clock",
                             transition.origin.span);
        // No source says whether such a deadline runs.
        if (ir::preconditions_can_fail(project().system, project().instantiation, {}, *transition.deadline))
            project().refuse("the deadline of " + transition.name + " by a function with a precondition",
                             transition.origin.span);
        Cell cell;
        cell.kind = CellKind::monitor;
        cell.name = "m_" + frame.prefix + transition.name;
        cell.meaning = "time left for " + transition.name;
        cell.deadline = transition.origin;
        frame.monitors[i] = add_cell(cell);
    }
}

const ir::Machine* MachineEmitter::definition_of(const Frame& frame, ir::OperationId operation) const {
    const auto found = context_.definitions.find(frame.machine->operations.at(operation.index).name);
    return found == context_.definitions.end() ? nullptr : &project().system.machine(found->second);
}

/// The operations defined in this context that the machine calls, itself or through others.
std::vector<const ir::Machine*> MachineEmitter::callable() const {
    std::vector<const ir::Machine*> result;
    for (const auto& [name, id] : context_.definitions) {
        const ir::Machine* operation = &project().system.machine(id);
        if (std::find(reached_.begin(), reached_.end(), operation) != reached_.end()) result.push_back(operation);
    }
    return result;
}

std::uint32_t MachineEmitter::callee_frame(std::uint32_t caller, const ir::Stmt& call, const ir::Machine& operation) {
    const auto place = std::make_pair(caller, &call);
    if (const auto found = callees_.find(place); found != callees_.end()) return found->second;
    // Deep chains of calls: names with all callers in front would make the script quadratic.
    constexpr std::size_t longest = 40;
    const std::string& above = frames_[caller].prefix;
    const std::string prefix = (above.size() < longest ? above : "") + operation.name + "_";
    return callees_[place] = open_frame(operation, caller, prefix);
}

ExprPtr MachineEmitter::value_of(CellId cell, const Values& values) const {
    const auto found = values.find(cell);
    return found == values.end() ? b::name(cells_[cell].name) : found->second;
}

Scope MachineEmitter::scope(std::uint32_t index, const Values& values, ExprPtr trigger_value) const {
    Scope result;
    const auto values_now = std::make_shared<const Values>(values);  // a scope may outlive what it was made with
    result.variable = [this, index, values_now](ir::VariableId id) {
        return value_of(frames_[index].variables.at(id.index), *values_now);
    };
    result.constant = [this, index](ir::ConstantId id) { return frames_[index].constants.at(id.index); };
    result.clock = [this, index, values_now](ir::ClockId id) {
        return value_of(frames_[index].clocks.at(id.index).value(), *values_now);
    };
    result.entry_clock = [this, index, values_now](ir::NodeId node) {
        const auto& clocks = frames_[index].machine->clocks;
        const auto found =
            std::find_if(clocks.begin(), clocks.end(), [&](const auto& c) { return c.entry_of == node; });
        const auto place = static_cast<std::size_t>(found - clocks.begin());
        return value_of(frames_[index].clocks.at(place).value(), *values_now);
    };
    result.trigger_value = std::move(trigger_value);
    return result;
}

CellId MachineEmitter::cell_for(std::uint32_t frame, const ir::Stmt& stmt, std::size_t index, CellKind kind,
                                const std::string& name) {
    const auto place = std::make_tuple(frame, &stmt, index);
    if (const auto found = statement_cells_.find(place); found != statement_cells_.end()) return found->second;
    Cell cell;
    cell.kind = kind;
    cell.name = name;
    cell.meaning = kind == CellKind::waiting    ? "wait left"
                   : kind == CellKind::deadline ? "deadline left"
                                                : "value read";
    if (kind == CellKind::deadline) cell.deadline = stmt.origin;
    return statement_cells_[place] = add_cell(cell);
}

}  // namespace robochart::csp_emit
