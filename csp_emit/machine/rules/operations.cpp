// SPDX-License-Identifier: Apache-2.0
// Starts a called operation: determines where it runs, and its initial values.
#include "csp_emit/machine/rules/operations.hpp"

#include <algorithm>

#include "checker/cspm/syntax/build.hpp"
#include "csp_emit/base/registers.hpp"
#include "csp_emit/base/rules.hpp"
#include "csp_emit/machine/rules/time.hpp"

namespace robochart::csp_emit {

namespace b = cspm::build;
using cspm::ExprPtr;

namespace {

/// True if the call runs without concurrency, so that the return address determines the caller's configuration.
bool may_share_call(const MachineTables& tables, const RunningThread& running, const Activation& returned) {
    // A shared operation runs in a separate configuration, which does not contain the state of its caller.
    if (!tables.project().options.share_calls || tables.context.shows_states() || tables.machine().robosim)
        return false;
    if (running.during || returned.frame != running.frame()) return false;
    if (!returned.durings.empty() || returned.control.callee) return false;
    for (const Link* link = returned.control.rest.get(); link != nullptr; link = link->tail.get())
        if (!link->head.cells.empty()) return false;
    return active_monitors(tables, view_of(returned), {}).empty();
}

/// Returns the initial values of a called operation: its parameters, its own variables and clocks.
Values called_values(MachineTables& tables, const RunningThread& running, const ir::Stmt& stmt, std::uint32_t callee,
                     const Values& values) {
    const Frame& frame = tables.frames[callee];
    Values inside = values;
    std::size_t parameter = 0;
    for (std::size_t i = 0; i < frame.machine->variables.size(); ++i) {
        const ir::Variable& variable = frame.machine->variables[i];
        const CellId cell = frame.variables[i];
        if (std::ranges::find(frame.own, cell) == frame.own.end()) continue;  // belongs to the caller
        const bool given = variable.scope == ir::VariableScope::parameter && parameter < stmt.args.size();
        inside[cell] = given ? expression_as(tables.project(), tables.frames.make_scope(running.frame(), values),
                                             *stmt.args[parameter++], variable.type)
                             : initial_value(tables, callee, variable);
    }
    for (const CellId cell : frame.own)
        if (tables.cells[cell].kind == CellKind::clock) inside[cell] = b::number(0);
    return inside;
}

/// Returns the preconditions of the operation, preceded by those of the functions that they call.
b::Exprs preconditions_of(const MachineTables& tables, const ir::Machine& operation, std::uint32_t frame,
                          const Values& inside) {
    const Scope names = tables.frames.make_scope(frame, inside);
    b::Exprs result;
    for (const auto& condition : operation.preconditions) {
        for (auto& first : translate_preconditions(tables.project(), names, *condition)) result.push_back(first);
        result.push_back(translate_expression(tables.project(), names, *condition));
    }
    return result;
}

}  // namespace

Next call_operation(MachineTables& tables, const RunningThread& running, const ir::Stmt& stmt, const Program& rest,
                    const Values& values) {
    const std::uint32_t caller = running.frame();
    const ir::Machine& operation = *tables.frames.find_definition(caller, stmt.operation);
    const Activation returned = running.replace(rest);
    if (!operation.initial.is_valid()) {  // no body: SKIP |~| STOP; SKIP if declared `terminates`
        Next skip = next_configuration(returned, values);
        if (operation.terminates) return skip;
        return {Next::Kind::internal, {}, {}, {}, {std::move(skip), next_configuration(block_thread(running), values)}};
    }
    const std::string chain = tables.calls.describe_recursion(*tables.frames[caller].machine, operation);
    if (!chain.empty()) {
        tables.project().diagnostics.report(rules::recursive_call, stmt.origin.span, {operation.name, chain});
        return next_process(b::stop());
    }
    const bool shared = may_share_call(tables, running, returned);
    const std::uint32_t index =
        shared ? tables.frames.shared_frame(caller, operation) : tables.frames.frame_of_call(caller, stmt, operation);
    Values inside = called_values(tables, running, stmt, index, values);
    Activation body;
    body.frame = index;
    body.at = operation.initial;
    if (shared) tables.sharing.push_return(index, returned, values, inside);
    const b::Exprs conditions = preconditions_of(tables, operation, index, inside);
    Next called = next_configuration(
        shared ? body : running.replace(Thread{rest, std::make_shared<const Activation>(body)}), std::move(inside));
    if (conditions.empty()) return called;
    return next_if(b::all_of(conditions), std::move(called), next_configuration(block_thread(running), values));
}

Branch call_event(const MachineTables& tables, const RunningThread& running, const ir::Stmt& stmt,
                  const b::Exprs& arguments) {
    const ir::OperationSignature& called = tables.frames[running.frame()].machine->operations.at(stmt.operation.index);
    std::vector<cspm::Field> fields;
    for (const ExprPtr& argument : arguments) fields.push_back(b::output(argument));
    return {nullptr, called.output ? register_write("o_" + called.name) : b::name(called.name + "Call"),
            std::move(fields), next_configuration(running.replace(running.tail()), {})};
}

}  // namespace robochart::csp_emit
