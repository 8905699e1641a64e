// Whether two controllers do the same: L(G) and L(G') as graphs, strongly bisimilar or not. Finer than the equality of
// their failures and divergences, so "same" holds in every model of CSP.
#pragma once

#include <optional>
#include <string>

#include "checker/refine/verdict/check.hpp"
#include "conformance/code/code_system.hpp"

namespace robochart::conformance {

struct CodeEquality {
    bool same = false;
    std::uint64_t states = 0;  ///< of both graphs together
    /// Not the same: a shortest trace of the one that the other does not have, or where it refuses or diverges
    /// otherwise; "" if only their branching differs.
    std::string difference;
    std::size_t cycles = 0;  ///< of that trace, begun ones included
};

/// Both over one alphabet. Throws process::Interrupted where a limit is reached.
[[nodiscard]] CodeEquality compare_code(const rc_interface& one, const rc_interface& other, const Alphabet&,
                                        std::uint32_t cycle_length, const refine::Limits&);

}  // namespace robochart::conformance
