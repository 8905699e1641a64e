// SPDX-License-Identifier: Apache-2.0
// Computes the value at which a clock saturates (semantics 3.10): one more than the largest value with which a guard
// compares it.
#pragma once

#include <string>
#include <vector>

#include "csp_emit/machine/tables/call_graph.hpp"

namespace robochart::csp_emit {

/// Owns the functions that compute limits from constants.
class ClockLimits {
public:
    ClockLimits(const Project& project, const CallGraph& calls, NameManager& names)
        : project_(project), calls_(calls), names_(names) {}

    /// Returns one more than the largest value with which the clock, or the clock of a state, is compared. The result
    /// is a number, or a call of a function of the constants if some bound is not a literal.
    [[nodiscard]] cspm::ExprPtr limit_of(const ir::Machine& opened, const std::string& clock, ir::NodeId entry_of);
    [[nodiscard]] const std::vector<cspm::DeclPtr>& declarations() const { return declarations_; }

private:
    cspm::ExprPtr bound_in_units(const ir::Machine& checked, const ir::Expr& bound,
                                 std::vector<cspm::Clause>& variables) const;

    const Project& project_;
    const CallGraph& calls_;
    NameManager& names_;
    std::vector<cspm::DeclPtr> declarations_;
};

}  // namespace robochart::csp_emit
