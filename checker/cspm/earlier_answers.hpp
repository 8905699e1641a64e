// SPDX-License-Identifier: Apache-2.0
// Stores the answers of checks in a cache for later runs. An assertion is identified by the content of its compiled
// processes. So its answer stays valid after every edit of the script that does not change these processes.
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

/// The key of a check in the cache, and the events with which its answer is encoded.
struct QuestionKey {
    diagnostics::Digest digest;
    process::EventSet named;
};

/// Returns the key of a check on compiled processes. Returns no value in three cases: the process is not compiled; the
/// specification is neither compiled nor small; or a complete exploration of the specification fails or takes longer
/// than `longest`. Without `longest`, the result does not depend on time. Polls the budget during the exploration.
[[nodiscard]] std::optional<QuestionKey> key_of(const Question&, diagnostics::Pollable& budget,
                                                const std::optional<std::chrono::milliseconds>& longest);

/// Returns the key of a check on packed states (packed/packed_system.hpp). Packed states depend on the script, so the
/// key covers the whole script, the assertion, and the names of its events in their order. `events`: the events of all
/// channels of the script.
[[nodiscard]] QuestionKey key_of_packed(const Question&, const Script& script, const Decl& assertion,
                                        const process::EventSet& events);

/// The time limit for exploring a specification if the key is only needed to save time.
inline constexpr std::chrono::milliseconds longest_look{1000};

/// The cache for answers, and how large a search must be for its answer to be stored.
struct Memory {
    diagnostics::Cache* cache = nullptr;
    std::uint64_t fewest_states = 0;
};

/// Runs the check, and uses the findings of an earlier run if the cache contains them. Findings that are not confirmed
/// are not used. Stores the findings of this run if the search was large enough. `ask` runs the check (check.hpp) with
/// the findings of the earlier run.
[[nodiscard]] refine::Verdict check_with_memory(const Question&, const QuestionKey&, const Memory&,
                                                const std::function<refine::Verdict(refine::Earlier)>& ask);
/// Runs a check on packed states. If its rows become wider, the check runs again, and the states in its findings have
/// the new width. Therefore, when the check has been answered, the findings are also stored under its original key.
[[nodiscard]] refine::Verdict answer_of_width(const Question&, const QuestionKey&, const Memory&,
                                              const std::function<refine::Verdict(refine::Earlier)>& ask);

}  // namespace robochart::cspm
