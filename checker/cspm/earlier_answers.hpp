// Answers of earlier runs. A question is known by the content of the compiled processes that it is about, so it is the
// same question after every edit that leaves these processes what they were, whatever it does to the rest of the
// script.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>

#include "checker/cspm/syntax/syntax.hpp"
#include "checker/lts/transition_system.hpp"
#include "checker/refine/verdict/check.hpp"
#include "diagnostics/cache/cache.hpp"

namespace robochart::cspm {

/// What is asked of one or two processes that share their events.
struct Question {
    AssertionKind kind = AssertionKind::deadlock_free;
    refine::Model model = refine::Model::traces;
    lts::TransitionSystem* specification = nullptr;  ///< of a refinement; else null
    lts::TransitionSystem* process = nullptr;
    std::uint64_t max_states = 0;
    bool reduction = false;  ///< whether the search may leave states out: its figures are others then
};

/// The name of a question in the cache, and the events that its answer is written with.
struct QuestionKey {
    diagnostics::Digest digest;
    process::EventSet named;
};

/// None where the process is not compiled, the specification is neither compiled nor small, or looking at all of it
/// fails or takes longer than `longest`. Without `longest`, whether there is one does not depend on the time that it
/// takes. Throws what `poll` throws.
[[nodiscard]] std::optional<QuestionKey> key_of(const Question&, const std::function<void()>& poll,
                                                const std::optional<std::chrono::milliseconds>& longest);

/// For answers that are a help alone.
inline constexpr std::chrono::milliseconds longest_look{1000};

/// Where answers are kept, and of which searches.
struct Memory {
    diagnostics::Cache* cache = nullptr;
    std::uint64_t fewest_states = 0;
};

/// Asks, with the findings of an earlier run where the memory has them, and keeps the findings of a search
/// that was large enough. `ask` decides the question (check.hpp) with what is known. Findings that are not confirmed
/// are not used.
[[nodiscard]] refine::Verdict answer(const Question&, const QuestionKey&, const Memory&,
                                     const std::function<refine::Verdict(refine::Earlier)>& ask);

}  // namespace robochart::cspm
