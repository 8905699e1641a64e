// SPDX-License-Identifier: Apache-2.0
// Decides by the form of an expression, and of the functions that it calls, whether it denotes a process.
#include "checker/cspm/eval/process_shape.hpp"

#include <algorithm>

#include "checker/cspm/types/builtins.hpp"

namespace robochart::cspm {

bool ProcessShape::makes_process(const Function& function) {
    if (function.process >= 0) return function.process == 1;
    function.process = 0;  // a recursive call during this query finds 0
    ++open_;
    const bool result = std::ranges::any_of(
        function.clauses, [this](const FunctionClause& clause) { return makes_process(*clause.body); });
    // While an outer query is open, a recursive call may have caused a negative answer. Such an answer is not stored.
    const bool open = --open_ > 0;
    if (result)
        function.process = 1;
    else
        function.process = open ? std::int8_t{-1} : std::int8_t{0};
    return result;
}

// Returns true if a name, followed by this many groups of arguments, denotes a process.
bool ProcessShape::makes_process(const Code& name, std::size_t groups) {
    if (name.kind != ExprKind::name) return false;
    if (name.reference == Reference::builtin) {
        const auto which = static_cast<Builtin>(name.slot);
        const bool relation = which >= Builtin::mtransclose && which <= Builtin::transpose;
        return which >= Builtin::stop && !relation && (groups == 0) == (builtin_name(which).arguments < 0);
    }
    const Function* function = nullptr;
    if (name.reference == Reference::global) {
        const Global& global = program_.globals[static_cast<std::size_t>(name.slot)];
        if (global.kind == GlobalKind::function) function = &global.function;
    }
    if (name.reference == Reference::member) {
        const Member& member = name.group->members[static_cast<std::size_t>(name.index)];
        if (member.component_of < 0) function = &member.function;
    }
    return function != nullptr && function->groups.size() == groups && makes_process(*function);
}

bool ProcessShape::makes_process(const Code& code) {
    switch (code.kind) {
        case ExprKind::if_then_else:
            return makes_process(*code.args[1]) || makes_process(*code.args[2]);
        case ExprKind::let:
            return makes_process(*code.args[0]);
        case ExprKind::name:
            return makes_process(code, 0);
        case ExprKind::apply: {
            const Code* function = code.args[0];
            std::size_t groups = 1;
            for (; function->kind == ExprKind::apply; ++groups) function = function->args[0];
            return makes_process(*function, groups);
        }
        default:
            return (code.kind >= ExprKind::prefix && code.kind <= ExprKind::rename) ||
                   (code.kind >= ExprKind::replicated_external && code.kind <= ExprKind::replicated_synchronising);
    }
}

}  // namespace robochart::cspm
