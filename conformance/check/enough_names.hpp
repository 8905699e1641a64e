// SPDX-License-Identifier: Apache-2.0
// Computes how many names of each represented type are enough for a check to be valid for all values
// (docs/conformance.md, "Few values for all"). This depends only on the model and not on the code.
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

/// Finds out how many names are enough. If NF_c(M) does not choose between values, the answer is `least_names`.
/// Otherwise it is the least number that exceeds the number of live names after any trace. If a limit is reached or the
/// evaluation fails, returns the reason instead.
[[nodiscard]] EnoughNames enough_names(const RenamedSystem&, const ir::ComponentRef&, const cpp_emit::Component&,
                                       const Options&, diagnostics::SourceManager&);

}  // namespace robochart::conformance
