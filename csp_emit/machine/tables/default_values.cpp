// SPDX-License-Identifier: Apache-2.0
// Writes small default values in place. A large default value becomes a named definition.
#include "csp_emit/machine/tables/default_values.hpp"

#include <algorithm>

#include "checker/cspm/syntax/build.hpp"
#include "checker/cspm/syntax/lookup.hpp"
#include "csp_emit/base/types.hpp"

namespace robochart::csp_emit {
namespace {

/// The maximal number of nodes of a value that is written in place.
constexpr std::size_t largest_inline = 40;

/// True if the expression has more than `nodes` nodes. Decreases `nodes` by the number of visited nodes.
bool larger_than(const cspm::Expr& expr, std::size_t& nodes) {
    if (nodes == 0) return true;
    --nodes;
    return std::ranges::any_of(expr.args, [&](const cspm::ExprPtr& part) { return part && larger_than(*part, nodes); });
}

}  // namespace

cspm::ExprPtr DefaultValues::value_of(ir::TypeId type) {
    const auto [found, added] = known_.try_emplace(type.index);
    if (!added) return found->second;
    cspm::ExprPtr& value = found->second = default_literal(project_, type);
    std::size_t nodes = largest_inline;
    if (!larger_than(*value, nodes)) return value;
    declarations_.push_back(cspm::build::value("default_" + std::to_string(declarations_.size()) + "__", value));
    return value = cspm::build::name(cspm::declared_names(*declarations_.back()).front());
}

}  // namespace robochart::csp_emit
