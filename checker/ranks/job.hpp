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
    unsigned threads = 1;  ///< number of threads in each program
    std::optional<std::chrono::steady_clock::time_point> deadline;
};

/// Encodes a search of a system as bytes, with the limits for every program and the number of threads in each. Returns
/// no value if the system cannot be sent because its process was not compiled (it is still a term). `program`: the
/// identity of the sender.
[[nodiscard]] std::optional<std::string> encode(const lts::TransitionSystem& system,
                                                const refine::LevelQuestion& question, const refine::Limits& limits,
                                                unsigned threads, std::string_view program);
/// Returns the identity of the program that has encoded the search. This also works for searches that other versions
/// encoded. Throws lts::BadBytes.
[[nodiscard]] std::string sender_of(std::string_view bytes);
/// Decodes a search. `terms` must outlive the result; it may differ from the sender's store of terms. Throws
/// lts::BadBytes if this version has not encoded the bytes.
[[nodiscard]] Job decode(std::string_view bytes, process::TermStore& terms);

}  // namespace robochart::ranks
