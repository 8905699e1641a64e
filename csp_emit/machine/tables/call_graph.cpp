// SPDX-License-Identifier: Apache-2.0
// Computes reachability and cycles in the call graph.
#include "csp_emit/machine/tables/call_graph.hpp"

#include <algorithm>
#include <map>

#include "semantics/ir/query.hpp"

namespace robochart::csp_emit {
namespace {

/// For each operation of a context, the called operations that the context defines.
using Callees = std::map<const ir::Machine*, std::vector<const ir::Machine*>>;

Callees find_callees(const std::vector<const ir::Machine*>& definitions) {
    std::map<std::string, const ir::Machine*> by_name;
    for (const ir::Machine* definition : definitions) by_name[definition->name] = definition;
    Callees result;
    for (const ir::Machine* definition : definitions)
        for (const ir::OperationId called : ir::called_operations(*definition))
            if (const auto found = by_name.find(definition->operations[called.index].name);
                found != by_name.end() && !definition->operations[called.index].output)
                result[definition].push_back(found->second);
    return result;
}

/// True if the calls have a cycle. Operations without callers are removed one after the other. If some remain, there is
/// a cycle (Kahn 1962).
bool has_cycle(const Callees& callees) {
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
    return std::ranges::any_of(callers, [](const auto& left) { return left.second > 0; });
}

}  // namespace

CallGraph::CallGraph(MachineContext& context) : context_(context) {
    collect_calls(*context.machine, context.names);
    recursive_ = has_cycle(find_callees(callable_operations()));
}

void CallGraph::collect_calls(const ir::Machine& owner, NameManager& names) {
    if (std::ranges::find(reached_, &owner) != reached_.end()) return;
    reached_.push_back(&owner);
    const auto is_cycle = [](const ir::Constant& constant) { return constant.name == ir::cycle_length; };
    for (const bool cycle : {true, false})  // RoboTool's parameter for the length of the cycle comes first
        for (std::uint32_t i = 0; i < owner.constants.size(); ++i) {
            const ir::Constant& constant = owner.constants[i];
            if (is_cycle(constant) != cycle) continue;
            const std::string name = ir::constant_name(owner.package, owner.path, constant.name);
            constants_.push_back({name,
                                  constant.name,
                                  name,
                                  &owner,
                                  {i},
                                  constant.type,
                                  names.unique_name(flatten_name(constant.name))});
        }
    for (const ir::OperationId called : ir::called_operations(owner))
        if (const ir::Machine* operation = find_definition(owner, called)) collect_calls(*operation, names);
}

const ir::Machine* CallGraph::find_definition(const ir::Machine& caller, ir::OperationId operation) const {
    if (caller.operations.at(operation.index).output) return nullptr;
    const auto found = context_.definitions.find(caller.operations.at(operation.index).name);
    return found == context_.definitions.end() ? nullptr : &context_.project->system.machine(found->second);
}

std::vector<const ir::Machine*> CallGraph::callable_operations() const {
    std::vector<const ir::Machine*> result;
    for (const auto& [name, id] : context_.definitions) {
        const ir::Machine* operation = &context_.project->system.machine(id);
        if (std::ranges::find(reached_, operation) != reached_.end()) result.push_back(operation);
    }
    return result;
}

std::string CallGraph::describe_recursion(const ir::Machine& caller, const ir::Machine& operation) const {
    if (!recursive_) return "";
    const Callees calls = find_callees(callable_operations());
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

std::vector<std::string> CallGraph::constants_inside() const {
    std::vector<std::string> result;
    for (const ConstantParameter& constant : constants_) result.push_back(constant.inside);
    return result;
}

}  // namespace robochart::csp_emit
