// SPDX-License-Identifier: Apache-2.0
// Encodes a search as bytes. Rank 0 sends them to all other ranks.
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
    unsigned threads = 1;  ///< number of threads in each program
    std::optional<std::chrono::steady_clock::time_point> deadline;
};

/// Encodes a search: a system, the limits for every program, and the number of threads in each. Returns no value if the
/// states of the system are terms, because the process was not compiled; such a system cannot be sent. `program`
/// identifies the sender.
[[nodiscard]] std::optional<std::string> encode(const lts::TransitionSystem& system,
                                                const refine::LevelQuestion& question, const refine::Limits& limits,
                                                unsigned threads, std::string_view program);
/// Returns the identity of the program that has encoded the search. Another version of the program may have encoded it.
/// Throws lts::BadBytes.
[[nodiscard]] std::string sender_of(std::string_view bytes);
/// Decodes a search. `terms` need not be the sender's store of terms, but must outlive the result. Throws lts::BadBytes
/// if this version has not encoded the bytes.
[[nodiscard]] Job decode(std::string_view bytes, process::TermStore& terms);

}  // namespace robochart::ranks
