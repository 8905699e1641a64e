// SPDX-License-Identifier: Apache-2.0
// See open_constants.hpp.
#include "semantics/ir/open_constants.hpp"

#include <algorithm>

#include "semantics/ir/query.hpp"
#include "semantics/ir/visit.hpp"

namespace robochart::ir {
namespace {

bool spans_overlap(diagnostics::Span a, diagnostics::Span b) {
    return a.is_known() && b.is_known() && a.source == b.source && a.begin < b.end && b.begin < a.end;
}

/// True if no constant of this name has a value in the model. A required constant has the value of its provider.
bool is_open(const System& system, const std::string& name) {
    const auto ends = [&](const std::string& path) { return path.ends_with("::" + name); };
    const std::vector<NamedConstant> constants = named_constants(system);
    return std::ranges::none_of(constants, [&](const NamedConstant& constant) {
        const auto mentioned = [&](const CspBlock& block) {
            return is_instantiations(block) && block.text.find(constant.name) != std::string::npos;
        };
        return ends(constant.path) && (constant.has_value || std::ranges::any_of(system.csp_blocks, mentioned));
    });
}

}  // namespace

std::vector<std::string> open_divisors(const System& system, diagnostics::Span place) {
    std::vector<std::string> result;
    for (const Machine& machine : system.machines) {
        const auto add_constant = [&](const Expr& part) {
            if (part.kind != ExprKind::constant || part.constant.index >= machine.constants.size()) return;
            const std::string& name = machine.constants[part.constant.index].name;
            if (std::ranges::find(result, name) == result.end() && is_open(system, name)) result.push_back(name);
        };
        visit_expressions(machine, [&](const Expr& root, ExprRole) {
            visit_operands(root, [&](const Expr& expr) {
                const bool divides = expr.kind == ExprKind::divide || expr.kind == ExprKind::modulus;
                if (divides && spans_overlap(expr.span, place)) visit_operands(*expr.args[1], add_constant);
            });
        });
    }
    return result;
}

}  // namespace robochart::ir
