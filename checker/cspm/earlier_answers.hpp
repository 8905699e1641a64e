// SPDX-License-Identifier: Apache-2.0
// Stores the answers of checks in a cache for later runs. The content of its compiled processes identifies an
// assertion. So an answer stays valid after edits of the script that do not change these processes.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>

#include "base/cache/cache.hpp"
#include "base/diagnostics/pollable.hpp"
#include "checker/cspm/syntax/syntax.hpp"
#include "checker/lts/transition_system.hpp"
#include "checker/refine/verdict/check.hpp"

namespace robochart::cspm {

/// A check of one or two processes that share their events.
struct Question {
    AssertionKind kind = AssertionKind::deadlock_free;
    refine::Model model = refine::Model::traces;
    lts::TransitionSystem* specification = nullptr;  ///< for a refinement; otherwise null
    lts::TransitionSystem* process = nullptr;
    std::uint64_t max_states = 0;
    bool reduction = false;  ///< whether the search may skip states, which changes its statistics
};

/// The cache key of a check, and the events that its encoded answer may refer to.
struct QuestionKey {
    diagnostics::Digest digest;
    process::EventSet named;
};

/// Returns the cache key of a check on compiled processes. Returns no value if the process is not compiled. A
/// specification that is not compiled must be small: there is no key if its exploration fails or takes longer than
/// `longest`. Without `longest`, time does not affect the result. Polls the budget while it explores.
[[nodiscard]] std::optional<QuestionKey> key_of(const Question&, diagnostics::Pollable& budget,
                                                const std::optional<std::chrono::milliseconds>& longest);

/// Returns the cache key of a check on packed states (packed/packed_system.hpp). The bytes of packed states depend on
/// the script. Therefore the key covers the whole script, the assertion, and the names of the events in order. `events`
/// must contain the events of all channels of the script.
[[nodiscard]] QuestionKey key_of_packed(const Question&, const Script& script, const Decl& assertion,
                                        const process::EventSet& events);

/// Limits the exploration of a specification if its key can only save time.
inline constexpr std::chrono::milliseconds longest_look{1000};

/// The cache for answers, and how many states a search must find before its answer is stored.
struct Memory {
    diagnostics::Cache* cache = nullptr;
    std::uint64_t fewest_states = 0;
};

/// Runs a check by calling `ask` (check.hpp) with the findings of an earlier run if the cache contains them. If
/// `ask` does not confirm these findings, searches again. Stores the findings of this run if its search was large
/// enough.
[[nodiscard]] refine::Verdict check_with_memory(const Question&, const QuestionKey&, const Memory&,
                                                const std::function<refine::Verdict(refine::Earlier)>& ask);
/// Runs a check on packed states. `ask` may widen the rows of the states and search again; the findings then contain
/// wider states. So the findings are stored both under a key that includes the first width and under `key`.
[[nodiscard]] refine::Verdict answer_of_width(const Question&, const QuestionKey&, const Memory&,
                                              const std::function<refine::Verdict(refine::Earlier)>& ask);

}  // namespace robochart::cspm
