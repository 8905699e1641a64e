// SPDX-License-Identifier: Apache-2.0
// Encodes a search as bytes, which rank 0 sends to the other ranks.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "checker/process/term.hpp"
#include "checker/refine/verdict/level_strategy.hpp"

namespace robochart::ranks {

/// The data that each rank needs for a search.
struct Job {
    std::unique_ptr<lts::TransitionSystem> system;
    refine::LevelQuestion question;
    std::uint64_t max_states = 0;
    std::uint64_t memory_bytes = 0;
    unsigned threads = 1;  ///< in each program
    std::optional<std::chrono::steady_clock::time_point> deadline;
};

/// Returns the search of a system as bytes, with the limits for every program and the number of threads in each. No
/// value if the system cannot be sent, because the process stays a term. `program`: the identity of the sender.
[[nodiscard]] std::optional<std::string> encode(const lts::TransitionSystem& system,
                                                const refine::LevelQuestion& question, const refine::Limits& limits,
                                                unsigned threads, std::string_view program);
/// Returns the identity of the program that has encoded the search. This works for all versions. Throws lts::BadBytes.
[[nodiscard]] std::string sender_of(std::string_view bytes);
/// Decodes a search. `terms` must outlive it and may differ from the sender's terms. Throws lts::BadBytes if the bytes
/// are not a search that this version has encoded.
[[nodiscard]] Job decode(std::string_view bytes, process::TermStore& terms);

}  // namespace robochart::ranks
