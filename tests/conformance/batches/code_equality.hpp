// SPDX-License-Identifier: Apache-2.0
// Determines whether two controllers have the same behaviour, that is, whether L(G) and L(G') are strongly bisimilar
// graphs. Bisimilarity is finer than equal failures and divergences, so "same" holds in every model of CSP.
#pragma once

#include <optional>
#include <string>

#include "checker/refine/verdict/check.hpp"
#include "conformance/code/code_system.hpp"

namespace robochart::conformance {

struct CodeEquality {
    bool same = false;
    std::uint64_t states = 0;  ///< total of both graphs
    /// If the behaviours differ, a shortest trace that only one controller has, or a trace with a different refusal or
    /// divergence. If only the branching differs, "".
    std::string difference;
    std::size_t cycles = 0;  ///< cycles of that trace, including incomplete ones
};

/// Compares two controllers with the same alphabet. Throws process::Interrupted if a limit is reached.
[[nodiscard]] CodeEquality compare_code(const rc_interface& one, const rc_interface& other, const Alphabet&,
                                        std::uint32_t cycle_length, const refine::Limits&);

}  // namespace robochart::conformance
