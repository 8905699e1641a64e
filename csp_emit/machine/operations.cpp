// Calls (semantics 3.8). Not defined in the context: one event `opCall.args`. Defined: the operation's machine runs
// and then goes on where it was called: written once for all calls (call_sharing.cpp), or in the place of the call
// where something else goes on beside, its parameters and variables joining the parameters of those points.
#include <algorithm>

#include "checker/cspm/syntax/build.hpp"
#include "csp_emit/machine/machine.hpp"
#include "csp_emit/base/rules.hpp"
#include "semantics/ir/query.hpp"

namespace robochart::csp_emit {

namespace b = cspm::build;
using cspm::ExprPtr;

bool MachineEmitter::defined(const Place& place, const ir::Stmt& stmt) const {
    return definition_of(frames_[place.owner->frame], stmt.operation) != nullptr;
}

ExprPtr MachineEmitter::call_event(const Place& place, const ir::Stmt& stmt, const std::vector<ExprPtr>& arguments) {
    const std::string& name = frames_[place.owner->frame].machine->operations.at(stmt.operation.index).name;
    const ExprPtr next = go(place.put({place.thread->rest->tail, nullptr}), {});
    std::vector<cspm::Field> fields;
    for (const ExprPtr& argument : arguments) fields.push_back(b::output(argument));
    return fields.empty() ? b::prefix(b::name(name + "Call"), next) : b::prefix(b::name(name + "Call"), fields, next);
}

namespace {

/// The operations that each operation of a context calls, among those defined there.
using Callees = std::map<const ir::Machine*, std::vector<const ir::Machine*>>;

Callees callees(const std::vector<const ir::Machine*>& definitions) {
    std::map<std::string, const ir::Machine*> by_name;
    for (const ir::Machine* definition : definitions) by_name[definition->name] = definition;
    Callees result;
    for (const ir::Machine* definition : definitions)
        for (const ir::OperationId called : ir::called_operations(*definition))
            if (const auto found = by_name.find(definition->operations[called.index].name); found != by_name.end())
                result[definition].push_back(found->second);
    return result;
}

/// Whether the calls go round somewhere: what nobody calls is taken away until nothing is left.
bool goes_round(const Callees& callees) {
    std::map<const ir::Machine*, std::size_t> callers;
    for (const auto& [caller, called] : callees)
        for (const ir::Machine* operation : called) ++callers[operation];
    std::vector<const ir::Machine*> work;
    for (const auto& [caller, called] : callees)
        if (callers.count(caller) == 0) work.push_back(caller);
    for (std::size_t i = 0; i < work.size(); ++i) {
        const auto found = callees.find(work[i]);
        if (found == callees.end()) continue;
        for (const ir::Machine* operation : found->second)
            if (--callers[operation] == 0) work.push_back(operation);
    }
    return std::any_of(callers.begin(), callers.end(), [](const auto& left) { return left.second > 0; });
}

}  // namespace

/// The calls from `operation` to `caller` and back, if the operation can come to call its caller: `o -> p -> o`.
std::string MachineEmitter::recursion(const ir::Machine& caller, const ir::Machine& operation) {
    if (!recursive_) recursive_ = goes_round(callees(callable()));
    if (!*recursive_) return "";
    const Callees calls = callees(callable());
    std::map<const ir::Machine*, const ir::Machine*> before{{&operation, nullptr}};
    std::vector<const ir::Machine*> work{&operation};
    for (std::size_t i = 0; i < work.size() && before.count(&caller) == 0; ++i)
        if (const auto found = calls.find(work[i]); found != calls.end())
            for (const ir::Machine* next : found->second)
                if (before.emplace(next, work[i]).second) work.push_back(next);
    if (before.count(&caller) == 0) return "";
    std::string chain = operation.name;
    for (const ir::Machine* at = &caller; at != nullptr; at = before.at(at)) chain = at->name + " -> " + chain;
    return chain;
}

/// What the operation starts with: its parameters, its own variables and clocks.
Values MachineEmitter::called_values(const Place& place, const ir::Stmt& stmt, std::uint32_t callee,
                                     const Values& values) const {
    const Frame& frame = frames_[callee];
    Values inside = values;
    std::size_t parameter = 0;
    for (std::size_t i = 0; i < frame.machine->variables.size(); ++i) {
        const ir::Variable& variable = frame.machine->variables[i];
        const CellId cell = frame.variables[i];
        if (std::find(frame.own.begin(), frame.own.end(), cell) == frame.own.end()) continue;  // the caller's
        const bool given = variable.scope == ir::VariableScope::parameter && parameter < stmt.args.size();
        inside[cell] =
            given ? expression_as(project(), scope(place.owner->frame, values), *stmt.args[parameter++], variable.type)
                  : initial_value(callee, variable);
    }
    for (const CellId cell : frame.own)
        if (cells_[cell].kind == CellKind::clock) inside[cell] = b::number(0);
    return inside;
}

ExprPtr MachineEmitter::perform_call(const Place& place, const ir::Stmt& stmt, const Program& rest,
                                     const Values& values) {
    const std::uint32_t caller = place.owner->frame;
    const ir::Machine& operation = *definition_of(frames_[caller], stmt.operation);
    const Activation returned = place.put({rest, nullptr});
    if (!operation.initial.valid()) {  // no body: SKIP |~| STOP, with `terminates` SKIP
        const ExprPtr skip = go(returned, values);
        return operation.terminates ? skip : b::internal_choice({skip, go(stuck(place), values)});
    }
    if (const std::string chain = recursion(*frames_[caller].machine, operation); !chain.empty()) {
        project().diagnostics.report(rules::recursive_call, stmt.origin.span, {operation.name, chain});
        return b::stop();
    }
    const bool shared = shares(place, returned);
    const std::uint32_t index = shared ? shared_frame(caller, operation) : callee_frame(caller, stmt, operation);
    Values inside = called_values(place, stmt, index, values);
    Activation body;
    body.frame = index;
    body.at = operation.initial;
    if (shared) {
        const ExprPtr places = push_return(index, returned, values);
        inside[*places_] = places;
    }
    const ExprPtr called = go(shared ? body : place.put({rest, std::make_shared<const Activation>(body)}), inside);
    b::Exprs conditions;
    for (const auto& condition : operation.preconditions) {
        for (auto& first : preconditions(project(), scope(index, inside), *condition)) conditions.push_back(first);
        conditions.push_back(expression(project(), scope(index, inside), *condition));
    }
    if (conditions.empty()) return called;
    return b::if_(b::all_of(conditions), called, go(stuck(place), values));
}

}  // namespace robochart::csp_emit
