// Calls (semantics 3.8). Not defined in the context: one event `opCall.args`. Defined: the operation's machine runs
// in the place of the call, its parameters and variables joining the parameters of those points.
#include <algorithm>

#include "checker/cspm/build.hpp"
#include "csp_emit/machine.hpp"
#include "csp_emit/rules.hpp"

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

/// The operations from the outermost caller to `operation`, if it is already being called.
std::string chain_to(const std::vector<Frame>& frames, std::uint32_t frame, const ir::Machine& operation) {
    std::string chain = operation.name;
    for (std::uint32_t index = frame; index != 0; index = frames[index].parent) {
        chain = frames[index].machine->name + " -> " + chain;
        if (frames[index].machine == &operation) return chain;
    }
    return "";
}

}  // namespace

ExprPtr MachineEmitter::perform_call(const Place& place, const ir::Stmt& stmt, const Program& rest,
                                     const Values& values) {
    const std::uint32_t caller = place.owner->frame;
    const ir::Machine& operation = *definition_of(frames_[caller], stmt.operation);
    const Activation returned = place.put({rest, nullptr});
    Item stuck = place.head();
    stuck.kind = ItemKind::stuck;
    if (!operation.initial.valid()) {  // no body: SKIP |~| STOP, with `terminates` SKIP
        const ExprPtr skip = go(returned, values);
        return operation.terminates
                   ? skip
                   : b::internal_choice({skip, go(place.put({push(stuck, nullptr), nullptr}), values)});
    }
    if (const std::string chain = chain_to(frames_, caller, operation); !chain.empty()) {
        project().diagnostics.report(rules::recursive_call, stmt.origin.span, {operation.name, chain});
        return b::stop();
    }
    const std::uint32_t index = callee_frame(caller, stmt, operation);
    Values inside = values;
    std::size_t parameter = 0;
    const std::vector<CellId> own = frames_[index].own;
    for (std::size_t i = 0; i < operation.variables.size(); ++i) {
        const ir::Variable& variable = operation.variables[i];
        const CellId cell = frames_[index].variables[i];
        if (std::find(own.begin(), own.end(), cell) == own.end()) continue;  // the caller's
        const bool given = variable.scope == ir::VariableScope::parameter && parameter < stmt.args.size();
        inside[cell] = given ? expression_as(project(), scope(caller, values), *stmt.args[parameter++], variable.type)
                             : initial_value(index, variable);
    }
    for (const CellId cell : own)
        if (cells_[cell].kind == CellKind::clock) inside[cell] = b::number(0);
    Activation body;
    body.frame = index;
    body.at = operation.initial;
    const ExprPtr called = go(place.put({rest, std::make_shared<const Activation>(body)}), inside);
    b::Exprs conditions;
    for (const auto& condition : operation.preconditions)
        conditions.push_back(expression(project(), scope(index, inside), *condition));
    if (conditions.empty()) return called;
    return b::if_(b::all_of(conditions), called, go(place.put({push(stuck, nullptr), nullptr}), values));
}

}  // namespace robochart::csp_emit
