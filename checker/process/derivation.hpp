// The firing rules read backwards: which moves of a term's operands make one of its transitions. Private to
// checker/process.
#pragma once

#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "checker/process/operational_semantics.hpp"

namespace robochart::process {

struct Derivation {
    std::vector<std::pair<std::size_t, Transition>> moves;  ///< operand, and what it did
    /// The operand that goes on alone, where the operator is resolved by the step.
    std::optional<std::size_t> survivor;
    bool starts = false;  ///< the survivor has not run before
};

/// As CSPM writes it.
[[nodiscard]] std::string_view name_of(Compression kind);
/// Operators whose steps come from their operands'.
[[nodiscard]] bool is_operator(Op op);
/// None where the step is not one of the term's, or comes from no operand.
[[nodiscard]] std::optional<Derivation> derivation(OperationalSemantics& semantics, TermId term,
                                                   const Transition& step);

}  // namespace robochart::process
