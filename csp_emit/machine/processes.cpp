// SPDX-License-Identifier: Apache-2.0
// Processes the work list of points and converts the rules' results to processes.
#include "csp_emit/machine/processes.hpp"

#include <algorithm>
#include <stdexcept>

#include "checker/cspm/syntax/build.hpp"
#include "csp_emit/machine/rules/actions.hpp"
#include "csp_emit/machine/rules/cycles.hpp"
#include "csp_emit/machine/rules/shared_variables.hpp"
#include "csp_emit/machine/rules/states.hpp"
#include "csp_emit/machine/rules/time.hpp"
#include "csp_emit/machine/rules/transitions.hpp"

namespace robochart::csp_emit {

namespace b = cspm::build;
using cspm::ExprPtr;

namespace {

/// The maximal number of statements executed before a new function begins. It limits the recursion and the size of
/// expressions.
constexpr std::size_t max_run = 100;

/// Returns the process of an operation without a body: `SKIP |~| STOP`, or `SKIP` if it is declared `terminates`. In
/// the timed semantics it may end at any time.
ExprPtr without_body(const MachineTables& tables) {
    const ExprPtr skip = tables.timed() ? b::name("SKIP_ANYTIME") : b::skip();
    const ExprPtr stop = tables.timed() ? b::call("RUN", {b::set({b::name("tock")})}) : b::stop();
    return tables.machine().terminates ? skip : b::internal_choice({skip, stop});
}

/// Returns the initial values. The parameters of an operation that is checked separately have the values that the
/// caller passes.
Values initial_values(MachineTables& tables) {
    Values result;
    const Frame& root = tables.frames.root_frame();
    for (std::size_t i = 0; i < root.machine->variables.size(); ++i) {
        const CellId cell = root.variables[i];
        result[cell] = tables.cells[cell].parameter ? tables.cells.parameter_name(cell)
                                                    : initial_value(tables, 0, root.machine->variables[i]);
    }
    for (const auto& clock : root.clocks)
        if (clock) result[*clock] = b::number(0);
    if (const auto& watch = tables.watch.reset_cell()) result[*watch] = b::boolean(false);
    return result;
}

/// True if the branch receives the event as an input.
bool is_input_of(const cspm::Expr& branch, const std::string& event) {
    const cspm::Expr& prefix = branch.kind == cspm::ExprKind::guard ? *branch.args[1] : branch;
    if (prefix.kind != cspm::ExprKind::prefix || prefix.args[0]->kind != cspm::ExprKind::dot) return false;
    const auto& parts = prefix.args[0]->args;
    return parts.size() > 1 && parts[0]->text == event && parts[1]->text == "in";
}

}  // namespace

Processes::Processes(MachineTables& tables) : tables_(tables) {
    if (tables.context.offered.empty() && tables.context.shown.empty()) return;
    Cell cell;
    cell.name = "passed__";
    cell.kind = CellKind::frozen;
    passed_ = tables.cells.add_cell(std::move(cell));
}

ExprPtr Processes::initial_process() {
    const ir::Machine& machine = tables_.machine();
    if (machine.kind == ir::MachineKind::operation && !machine.initial.is_valid()) return without_body(tables_);
    Activation start;
    start.at = machine.initial;
    if (machine.robosim && machine.kind == ir::MachineKind::state_machine) start = before_first_cycle(machine);
    return process_at(start, initial_values(tables_));
}

std::vector<Function> Processes::make_functions() {
    const std::vector<Point>& points = tables_.points.all();
    const std::vector<Continuation>& continuations = tables_.sharing.continuations();
    std::vector<Function> behind_calls;
    std::vector<Function> functions;
    while (functions.size() < points.size() || behind_calls.size() < continuations.size()) {
        if (functions.size() < points.size()) {
            const Point point = points[functions.size()];  // a copy, because others are added while its body is made
            // if there are too many points, no bodies are made
            ExprPtr body;
            if (!point.returns) body = tables_.points.has_overflowed() ? b::stop() : body_of(point.config);
            functions.push_back({point.name, {}, body});
        } else {
            const Continuation continuation = continuations[behind_calls.size()];
            behind_calls.push_back({continuation.name, {}, body_after_call(continuation)});
        }
    }
    for (std::size_t i = 0; i < points.size(); ++i)
        if (points[i].returns) functions[i].body = tables_.sharing.select_continuation(points[i].config.frame);
    tables_.sharing.fill_values();
    tables_.sharing.skip_returns(functions, behind_calls);
    functions.insert(functions.end(), behind_calls.begin(), behind_calls.end());
    return functions;
}

/// True if the configuration is the end of a shared operation.
bool Processes::returns_to_caller(const Activation& config) const {
    return config.frame != 0 && is_final(tables_, config);
}

/// Returns the process in this configuration with these values. It executes all steps that need no event, and then
/// calls the function of the resulting point.
ExprPtr Processes::process_at(const Activation& config, const Values& values) {
    if (tables_.points.has_overflowed()) return b::stop();  // reported already
    if (run_ >= max_run) return call_point(config, values);
    if (returns_to_caller(config)) return tables_.sharing.return_from(config.frame, values, after_tock_);
    const auto next = silent_step(tables_, config, values, branching_ > 0);
    if (!next) return call_point(config, values);
    ++run_;
    const ExprPtr result = to_process(*next);
    --run_;
    return result;
}

ExprPtr Processes::call_point(const Activation& config, const Values& values) {
    const Point* point = tables_.points.point_of(config);
    if (point == nullptr) return b::stop();  // too many points, reported already
    Values passed = with_monitors(tables_, config, values);
    if (passed_) passed[*passed_] = b::number(passing_ ? 1 : 0);
    tables_.points.count_call(passed.size());
    return tables_.family_calls.add_call(point->name, tables_.cells.to_arguments(passed), after_tock_);
}

ExprPtr Processes::to_process(const Next& next) {
    switch (next.kind) {
        case Next::Kind::configuration:
            return process_at(next.config, next.values);
        case Next::Kind::point:
            return call_point(next.config, next.values);
        case Next::Kind::conditional:
        case Next::Kind::branching: {
            const std::size_t more = next.kind == Next::Kind::branching ? 1 : 0;
            branching_ += more;
            const ExprPtr then = to_process(next.parts.at(0));
            const ExprPtr otherwise = to_process(next.parts.at(1));
            branching_ -= more;
            return b::if_(next.expr, then, otherwise);
        }
        case Next::Kind::wait_over: {
            const ExprPtr otherwise = to_process(next.parts.at(1));
            return b::if_(next.expr, to_process(next.parts.at(0)), otherwise);
        }
        case Next::Kind::internal: {
            b::Exprs parts;
            for (const Next& part : next.parts) parts.push_back(to_process(part));
            return b::internal_choice(parts);
        }
        case Next::Kind::interval: {
            cspm::Expr chosen = *b::replicated(cspm::ExprKind::replicated_internal, {b::generator("d__", next.expr)},
                                               to_process(next.parts.at(0)));
            chosen.span = next.span;  // the place where an empty interval is reported
            return std::make_shared<const cspm::Expr>(std::move(chosen));
        }
        case Next::Kind::process:
            break;
    }
    return next.expr;
}

ExprPtr Processes::to_process(const Branch& branch) {
    after_tock_ = branch.tock;
    const ExprPtr next = to_process(branch.next);
    after_tock_ = false;
    const ExprPtr event =
        branch.fields.empty() ? b::prefix(branch.event, next) : b::prefix(branch.event, branch.fields, next);
    return branch.guard ? b::guard(branch.guard, event) : event;
}

void Processes::add_branches(const std::vector<Branch>& branches, std::vector<ExprPtr>& out) {
    for (const Branch& branch : branches) out.push_back(to_process(branch));
}

/// Returns the external choice of the branches of the configuration. If the machine is a copy that observes when an
/// event is offered (MachineContext::offered), the point first performs an event that shows whether the machine is in
/// the state, and a parameter records this. The other branches are offered only after this event.
ExprPtr Processes::choice_of_branches(const Activation& config) {
    const b::Exprs all = make_branches(config);
    if (!passed_) return b::choice(all);
    if (!tables_.context.shown.empty()) return show_facts(config, all);
    const std::optional<ir::NodeId>& state = tables_.context.within;
    const bool inside = state ? is_in(tables_, config, *state) : !is_final(tables_, config);
    const auto with = [&](std::int64_t value) {
        return b::binary(cspm::ExprKind::equal, tables_.cells.parameter_name(*passed_), b::number(value));
    };
    passing_ = true;
    const ExprPtr again = call_point(config, {});
    passing_ = false;
    b::Exprs result{b::guard(with(0), b::prefix(b::name(inside ? "inside__" : "outside__"), again))};
    b::Exprs others;
    for (const ExprPtr& branch : all)
        (is_input_of(*branch, tables_.context.offered) ? result : others).push_back(branch);
    if (!others.empty()) result.push_back(b::guard(with(1), b::choice(others)));
    return b::choice(result);
}

/// Returns the event `shown__` with the truth of each fact, followed by the branches. The event changes neither values
/// nor configuration.
ExprPtr Processes::show_facts(const Activation& config, const b::Exprs& branches) {
    const auto behind = [&](std::int64_t value) {
        return b::binary(cspm::ExprKind::equal, tables_.cells.parameter_name(*passed_), b::number(value));
    };
    std::vector<cspm::Field> fields;
    for (const ShownFact& fact : tables_.context.shown)
        fields.push_back(b::output(fact.state ? b::boolean(is_in(tables_, config, *fact.state))
                                              : fact.condition(names_of_machine())));
    passing_ = true;
    const ExprPtr again = call_point(config, {});
    passing_ = false;
    b::Exprs result{b::guard(behind(0), b::prefix(b::name("shown__"), std::move(fields), again))};
    if (!branches.empty()) result.push_back(b::guard(behind(1), b::choice(branches)));
    return b::choice(result);
}

MachineNames Processes::names_of_machine() const {
    MachineNames names;
    names.variable = [this](ir::VariableId id) {
        return tables_.cells.parameter_name(tables_.frames.root_frame().variables.at(id.index));
    };
    names.constant = [this](ir::ConstantId id) {
        for (const ConstantParameter& constant : tables_.calls.constants())
            if (constant.owner == &tables_.machine() && constant.id == id) return b::name(constant.inside);
        throw std::logic_error("csp_emit: a fact names a constant that the machine does not have");
    };
    return names;
}

ExprPtr Processes::body_of(const Activation& config) {
    run_ = 0;
    branching_ = 0;
    if (returns_to_caller(config)) return tables_.sharing.return_from(config.frame, {}, false);
    if (const auto next = silent_step(tables_, config, {}, false)) return to_process(*next);
    const bool ends = is_final(tables_, config) && tables_.machine().kind == ir::MachineKind::operation;
    return tables_.watch.with_reset(ends ? b::skip() : choice_of_branches(config));
}

/// Returns the body of the function that continues after a shared call.
ExprPtr Processes::body_after_call(const Continuation& continuation) {
    run_ = 0;
    branching_ = 0;
    return process_at(continuation.config, tables_.sharing.stack_after_call(continuation));
}

/// Returns the branches that read a clock of the caller. It is read before any guard is evaluated (clocks_needed).
std::vector<ExprPtr> Processes::reading_branches(const Activation& config, const View& now, CellId clock) {
    std::vector<ExprPtr> result;
    Activation next = config;
    ++next.clocks_read;
    result.push_back(to_process(Branch{nullptr,
                                       b::name(tables_.cells[clock].reading),
                                       {b::input("in__")},
                                       next_configuration(next, {{clock, b::name("in__")}})}));
    for (const RunningThread& running : now.threads)
        if (const auto branch = head_branch(tables_, running, false)) result.push_back(to_process(*branch));
    add_branches(external_writes(tables_, config, now), result);
    const bool alone = now.threads.size() == 1;
    if (std::ranges::none_of(now.threads,
                             [&](const RunningThread& running) { return stops_time(tables_, running, alone); }))
        result.push_back(to_process(tock_branch(tables_, config, now)));
    return result;
}

std::vector<ExprPtr> Processes::make_branches(const Activation& settled) {
    if (tables_.machine().robosim) {
        std::vector<ExprPtr> result;
        add_branches(cycle_branches(tables_, settled), result);
        return result;
    }
    const View asking = view_of(settled);
    const std::vector<CellId> clocks = tables_.timed() ? clocks_needed(tables_, asking) : std::vector<CellId>{};
    if (settled.clocks_read < clocks.size()) return reading_branches(settled, asking, clocks[settled.clocks_read]);
    Activation config = settled;
    config.clocks_read = 0;
    const View now = view_of(config);
    std::vector<ExprPtr> result;
    // A visible termination is followed by ✓ (semantics 3.9).
    if (is_final(tables_, config)) result.push_back(b::prefix(b::name("terminate"), b::skip()));
    for (const RunningMachine& running : now.machines)
        for (const ir::TransitionId id : outgoing_transitions(tables_, *running.activation))
            result.push_back(to_process(fire_transition(tables_, running, id)));
    for (const RunningMachine& running : now.machines)
        for (const ir::TransitionId id : outgoing_transitions(tables_, *running.activation))
            if (const ExprPtr unset = tables_.watch.read_unset(running.activation->frame, id)) result.push_back(unset);
    for (const RunningThread& running : now.threads)
        if (const auto branch = head_branch(tables_, running, now.threads.size() == 1))
            result.push_back(to_process(*branch));
    add_branches(external_writes(tables_, config, now), result);
    if (tables_.timed() && !is_urgent(tables_, now)) result.push_back(to_process(tock_branch(tables_, config, now)));
    return result;
}

}  // namespace robochart::csp_emit
