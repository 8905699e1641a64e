// SPDX-License-Identifier: Apache-2.0
// See scope.hpp.
#include "prism/checks/scope.hpp"

#include <set>

#include "prism/checks/rules.hpp"

namespace robochart::prism {
namespace {

void declare(const Name& name, Scope::Symbol symbol, Scope& scope, diagnostics::Diagnostics& diagnostics) {
    if (!scope.symbols.emplace(name.text, symbol).second)
        diagnostics.report(rules::declared_twice, name.span, {name.text});
}

}  // namespace

void declare_constant(const Constant& constant, Scope& scope, diagnostics::Diagnostics& diagnostics) {
    declare(constant.name, {constant.type, false}, scope, diagnostics);
}

void declare_names(const CheckedModel& model, Scope& scope, diagnostics::Diagnostics& diagnostics) {
    scope.kind = model.kind;
    for (const Constant& constant : model.constants) declare_constant(constant, scope, diagnostics);
    for (const Variable& variable : model.variables) declare(variable.name, {variable.type, true}, scope, diagnostics);
    std::set<std::string_view> formulas;
    for (const Definition& formula : model.formulas)
        if (scope.symbols.contains(formula.name.text) || !formulas.insert(formula.name.text).second)
            diagnostics.report(rules::declared_twice, formula.name.span, {formula.name.text});
}

}  // namespace robochart::prism
