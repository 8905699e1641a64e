// SPDX-License-Identifier: Apache-2.0
// Finds out how many names of each represented type a component needs, so that a check with these names decides for all
// values (docs/conformance.md, "Few values for all"). The answer depends on the model alone, not on its code.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "base/diagnostics/diagnostic.hpp"
#include "conformance/check/result.hpp"
#include "conformance/model/renamed_model.hpp"
#include "cpp_emit/plan/component.hpp"

namespace robochart::conformance {

/// The largest number of names that is tried.
inline constexpr std::size_t most_names = 8;

/// A number of names that represent all values, or the reason why no such number was found.
struct EnoughNames {
    std::optional<std::size_t> names;  ///< no value: not decided, or more than `most_names`
    std::string reason;                ///< why `names` has no value
};

/// Finds the least number of names, at least `least_names`, that satisfies one of two conditions: NF_c(M) does not
/// choose between values, or there are more names than names that are live after any trace. If a limit is reached or
/// the evaluation fails, the result contains the reason.
[[nodiscard]] EnoughNames enough_names(const RenamedSystem&, const ir::ComponentRef&, const cpp_emit::Component&,
                                       const Options&, diagnostics::SourceManager&);

}  // namespace robochart::conformance
