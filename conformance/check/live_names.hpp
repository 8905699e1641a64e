// SPDX-License-Identifier: Apache-2.0
// Counts how many values NF_c(M) stores and may still write. If a component only passes values on, one name more than
// this represents all values (docs/conformance.md, "Few values for all").
#pragma once

#include <cstddef>
#include <vector>

#include "checker/refine/search/limits.hpp"
#include "conformance/model/cyclic_model.hpp"
#include "conformance/model/representatives.hpp"

namespace robochart::conformance {

/// Considers the traces of NF_c(M) in which each register is read with names that are not live. Returns, for each
/// represented type, the largest number of names that are live after such a trace, plus the number of values of the
/// type in the register that is read next. A name is live after a trace if NF_c(M) may then be in a state from which it
/// can write the name before it reads a register that contains it. The model must be instantiated with these
/// representatives. Throws diagnostics::LimitReached.
[[nodiscard]] std::vector<std::size_t> most_live_names(CyclicModel&, const Representatives&, const refine::Limits&);

}  // namespace robochart::conformance
