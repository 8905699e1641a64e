// SPDX-License-Identifier: Apache-2.0
// Counts the values that NF_c(M) stores and may still write. If a component only passes values on, this number plus one
// is enough to represent all values (docs/conformance.md, "Few values for all").
#pragma once

#include <cstddef>
#include <vector>

#include "checker/refine/search/limits.hpp"
#include "conformance/model/cyclic_model.hpp"
#include "conformance/model/representatives.hpp"

namespace robochart::conformance {

/// Returns, for each represented type, the largest number of names that are live after a trace of NF_c(M), plus the
/// number of values of the type in the register that is read next. Considers only traces in which each register is read
/// with names that are not live. A name is live after a trace if NF_c(M), from some state that it may have reached, can
/// write the name before it reads a register that contains this name. The model must have been instantiated with the
/// given representatives. Throws diagnostics::LimitReached.
[[nodiscard]] std::vector<std::size_t> most_live_names(CyclicModel&, const Representatives&, const refine::Limits&);

}  // namespace robochart::conformance
