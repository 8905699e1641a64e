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
    std::vector<std::pair<std::size_t, Transition>> moves;  ///< operand, and its transition
    /// The operand that continues alone if the step resolves the operator.
    std::optional<std::size_t> survivor;
    bool starts = false;  ///< whether the operand that continues alone starts with this step
};

/// The name in CSPM.
[[nodiscard]] std::string_view name_of(Compression kind);
/// Whether the steps of the operator come from its operands.
[[nodiscard]] bool is_operator(Op op);
/// Returns no value if the step is not a transition of the term, or if no operand causes it.
[[nodiscard]] std::optional<Derivation> derivation(OperationalSemantics& semantics, TermId term,
                                                   const Transition& step);

}  // namespace robochart::process
