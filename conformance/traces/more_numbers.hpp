// SPDX-License-Identifier: Apache-2.0
// Extends the carriers for a log. Logged numbers outside the carrier are replaced by numbers of the carrier for
// which the model's comparisons with constants give the same answers (conformance/model/logged_value.hpp). With a few
// numbers between each two constants, different logged numbers rarely get the same replacement.
#pragma once

#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::conformance {

/// Replaces the carriers of received sequences of numbers by one sequence of each class, if the component only stores
/// and tests them. Adds reals to the instantiation: numbers between, below and above the constants with which the
/// component compares reals. The scale becomes finer, so that there are such numbers. Returns the unchanged
/// instantiation if the component does not compare reals with constants, or if the numbers would be too large. Results
/// are not clipped if the component compares sums, or stores results: the next step back from a clipped result would go
/// wrong.
[[nodiscard]] ir::Instantiation with_more_numbers(const ir::System&, const ir::Instantiation&, const ir::ComponentRef&);

/// The same instantiation with a finer unit of reals: all reals are multiplied by the factor.
[[nodiscard]] ir::Instantiation in_finer_units(const ir::System&, const ir::Instantiation&, std::int64_t factor);

}  // namespace robochart::conformance
