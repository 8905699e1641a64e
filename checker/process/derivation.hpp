// SPDX-License-Identifier: Apache-2.0
// Applies the firing rules backwards: finds the moves of a term's operands that cause one of its transitions. Private
// to checker/process.
#pragma once

#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "checker/process/operational_semantics.hpp"

namespace robochart::process {

struct Derivation {
    std::vector<std::pair<std::size_t, Transition>> moves;  ///< operands that move, with their transitions
    /// If the step resolves the operator: the operand that continues alone.
    std::optional<std::size_t> survivor;
    bool starts = false;  ///< whether the operand that continues alone has not run before this step
};

/// Returns the name of the compression in CSPM.
[[nodiscard]] std::string_view name_of(Compression kind);
/// Returns true if the steps of the operator come from its operands.
[[nodiscard]] bool is_operator(Op op);
/// Returns the moves of the operands that cause this step. Returns no value if the step is not a transition of the
/// term, or if no operand causes it.
[[nodiscard]] std::optional<Derivation> derivation(OperationalSemantics& semantics, TermId term,
                                                   const Transition& step);

}  // namespace robochart::process
